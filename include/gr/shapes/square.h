#pragma once

#include "core/bounds.h"
#include "core/transform.h"
#include "gr/shapes/flat_side.h"
#include "gr/shapes/surface.h"

#include <cstdint>
#include <tuple>

namespace gr {

// The square [-1/2, 1/2]^2 in the x-z plane, facing -y: an area light.
struct Square {
    template<class>
    using With = Square;
    static constexpr bool isSolid = false, isEndless = false, isAxisFaced = false;

    std::uint32_t light = 0;  // index into the area lights of Scene::lights

    static auto parts(const Square&) { return std::tie(); }

    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        const Real t = -ray.origin.y / ray.direction.y;
        const Real x = ray.origin.x + ray.direction.x * t;
        const Real z = ray.origin.z + ray.direction.z * t;
        const core::Mask<Real> inside = (core::abs(x) <= Real(0.5f)) & (core::abs(z) <= Real(0.5f));
        return core::select(inside & (t > Real(0)) & (t < ray.tMax), t, Real(core::infinity));
    }

    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>&,
                               const core::Mask<Real>&) const {
        const core::Vec3<Real> p = ray.origin + ray.direction * t;
        return {{p.x, Real(0), p.z}, {Real(0), Real(-1), Real(0)}, ray.direction.y > Real(0)};
    }

    template<class Real>
    Coordinates<Real> coordinatesAt(const ShapePoint<Real>& point) const {
        const Coordinates<Real> flat = flatCoordinates<Real>(point.position, point.normal);
        return {flat.uv + core::Vec2<Real>(Real(0.5f)), flat.tangent};
    }

    std::vector<FlatSide> flatSides() const { return {}; }  // lamps are lifted off what they touch
    core::Bounds bounds() const { return {{-0.5f, 0, -0.5f}, {0.5f, 0, 0.5f}}; }
    core::Vec3f reachUnder(const core::Transform& map) const { return reachOfBox(map, {0.5f, 0, 0.5f}); }
};

}  // namespace gr
