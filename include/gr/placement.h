// Where an object stands.
#pragma once

#include "core/ray.h"
#include "core/transform.h"

#include <variant>

namespace gr {

// Scales along the axes, then moves. The same bits as an AffineMap's, but for the sign of a zero. Coefficient: float,
// or a batch with another map in each lane.
template<class Coefficient>
struct AlignedMapOf {
    core::Vec3<Coefficient> scale, translation;

    template<class Real>
    core::Vec3<Real> point(const core::Vec3<Real>& p) const {
        return vector(p) + core::Vec3<Real>(Real(translation.x), Real(translation.y), Real(translation.z));
    }
    template<class Real>
    core::Vec3<Real> vector(const core::Vec3<Real>& v) const {
        return v * core::Vec3<Real>(Real(scale.x), Real(scale.y), Real(scale.z));
    }
};
struct AlignedMap : AlignedMapOf<float> {
    operator core::Transform() const;
};

// There and back. Most objects stand with their axes along the world's: that takes half the memory, and it is the
// memory that a ray through a million objects waits for.
class Placement {
public:
    struct InPlace {};  // the object's space is the world
    struct Aligned {
        AlignedMap worldFromObject, objectFromWorld;
    };
    struct General {
        core::Transform worldFromObject, objectFromWorld;
        float condition;
    };

    Placement() = default;
    Placement(const Aligned& aligned) : place_(aligned) {}
    // The maps must outlive it.
    explicit Placement(const General* general) : place_(general) {}

    // The largest sum of a row's values in |worldFromObject| |objectFromWorld|: how much a rounding grows on its way
    // there and back.
    float condition() const {
        const auto* general = std::get_if<const General*>(&place_);
        return general == nullptr ? 1 : (*general)->condition;
    }
    bool isGeneral() const { return std::holds_alternative<const General*>(place_); }
    bool isInPlace() const { return std::holds_alternative<InPlace>(place_); }
    core::Transform worldFromObject() const;
    core::Transform objectFromWorld() const;
    // Of one that is not general.
    AlignedMap alignedWorldFromObject() const {
        const auto* aligned = std::get_if<Aligned>(&place_);
        return aligned != nullptr ? aligned->worldFromObject : AlignedMap{{core::Vec3f(1), core::Vec3f(0)}};
    }
    AlignedMap alignedObjectFromWorld() const {
        const auto* aligned = std::get_if<Aligned>(&place_);
        return aligned != nullptr ? aligned->objectFromWorld : AlignedMap{{core::Vec3f(1), core::Vec3f(0)}};
    }

    template<class Real>
    core::Ray<Real> toObject(const core::Ray<Real>& ray) const {
        if (const auto* aligned = std::get_if<Aligned>(&place_)) return along(aligned->objectFromWorld, ray);
        if (const auto* general = std::get_if<const General*>(&place_)) return along((*general)->objectFromWorld, ray);
        return ray;
    }

private:
    template<class Map, class Real>
    static core::Ray<Real> along(const Map& map, const core::Ray<Real>& ray) {
        return {map.point(ray.origin), map.vector(ray.direction), ray.tMax};
    }

    std::variant<InPlace, Aligned, const General*> place_;
};

}  // namespace gr
