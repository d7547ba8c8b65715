#pragma once

#include "core/bounds.h"
#include "gr/shapes/frustum.h"
#include "gr/shapes/shape_node.h"

#include <array>
#include <tuple>

namespace gr {

// Closed, of radius 1 about the y axis, from y = 0 to y = 1.
struct Cylinder {
    template<class>
    using With = Cylinder;
    static constexpr bool isSolid = true, isEndless = false, isAxisFaced = false;

    static auto parts(const Cylinder&) { return std::tie(); }

    template<class Real>
    Real level(const core::Vec3<Real>& p) const {
        return straight<Real>().level(p);
    }
    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        return spans(ray)[0].first(ray);
    }
    template<class Real>
    std::array<Interval<Real>, 1> spans(const core::Ray<Real>& ray) const {
        return straight<Real>().spans(ray);
    }
    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>& margin,
                               const core::Mask<Real>& front) const {
        return straight<Real>().surfaceAt(ray, t, margin, front);
    }
    template<class Real>
    Coordinates<Real> coordinatesAt(const ShapePoint<Real>& point) const {
        return straight<Real>().coordinatesAt(point);
    }

    std::vector<FlatSide> flatSides() const { return {squareAcrossY(0, 1, false), squareAcrossY(1, 1, true)}; }
    core::Bounds bounds() const { return {{-1, 0, -1}, {1, 1, 1}}; }
    // Half its axis, and its round foot.
    core::Vec3f reachUnder(const core::Transform& map) const {
        return glm::abs(map.y) * 0.5f + glm::sqrt(map.x * map.x + map.z * map.z);
    }

private:
    template<class Real>
    static Frustum<Real> straight() {
        return {Real(0)};
    }
};

struct CylinderNode {
    static constexpr core::Word kind = "cylinder", plural = "cylinders";

    glm::dvec3 foot{0};  // its middle
    double radius = 1, height = 1;

    Cylinder shape() const { return {}; }
    glm::dmat4 placeIn(const glm::dmat4& around) const { return shapePlace(around, foot, {radius, height, radius}); }
    std::string text() const { return nodeText(foot, radius, height); }
};

}  // namespace gr
