#pragma once

#include "core/bounds.h"
#include "core/transform.h"
#include "gr/shapes/flat_side.h"
#include "gr/shapes/shape_node.h"
#include "gr/shapes/surface.h"

#include <array>
#include <tuple>

namespace gr {

// The unit sphere at the origin.
struct Sphere {
    template<class>
    using With = Sphere;
    static constexpr bool isSolid = true, isEndless = false, isAxisFaced = false;

    static auto parts(const Sphere&) { return std::tie(); }

    // Less than 0 inside, more than 0 outside.
    template<class Real>
    Real level(const core::Vec3<Real>& p) const {
        return glm::dot(p, p) - Real(1);
    }

    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        return spans(ray)[0].first(ray);
    }

    // Haines et al., "Precision Improvements for Ray/Sphere Intersection" (Ray Tracing Gems, 2019): the discriminant
    // from the point of the line nearest to the centre, and both roots without cancellation.
    template<class Real>
    std::array<Interval<Real>, 1> spans(const core::Ray<Real>& ray) const {
        const Real a = glm::dot(ray.direction, ray.direction);
        const Real b = -glm::dot(ray.origin, ray.direction);
        const core::Vec3<Real> nearest = ray.origin + ray.direction * (b / a);
        const Real discriminant = Real(1) - glm::dot(nearest, nearest);
        const Real root = core::sqrt(a * core::max(discriminant, Real(0)));
        const Real q = b + core::select(b < Real(0), -root, root);  // not copysign: lanes may differ in a zero's sign
        const Real t1 = level(ray.origin) / q;
        const Real t2 = q / a;
        return {{{core::min(t1, t2), core::max(t1, t2), discriminant >= Real(0)}}};
    }

    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>& margin,
                               const core::Mask<Real>& front) const {
        const core::Vec3<Real> p = glm::normalize(ray.origin + ray.direction * t);
        // Seen from within, the sphere comes nearer sideways, by half the square of how far.
        const Real sagitta = core::min(Real(0.5f) * glm::dot(margin, margin), Real(0.5f));
        return {core::select(front, p, p * (Real(1) - sagitta)), p, front};
    }

    // v is the latitude, from the south pole to the north pole.
    template<class Real>
    Coordinates<Real> coordinatesAt(const ShapePoint<Real>& point) const {
        const core::Vec3<Real>& p = point.normal;
        const Real fromAxis = core::sqrt(p.x * p.x + p.z * p.z);
        const Real latitude = core::atan2<Real>(p.y, fromAxis) * Real(1 / core::pi);
        return {{longitudeOf(p), Real(0.5f) + latitude}, eastOf(p)};
    }

    std::vector<FlatSide> flatSides() const { return {}; }
    core::Bounds bounds() const { return {core::Vec3f(-1), core::Vec3f(1)}; }
    // A sphere reaches as far along each world axis as the root of the sum of squares.
    core::Vec3f reachUnder(const core::Transform& map) const {
        return glm::sqrt(map.x * map.x + map.y * map.y + map.z * map.z);
    }
};

struct SphereNode {
    static constexpr core::Word kind = "sphere", plural = "spheres";

    glm::dvec3 centre{0};
    double radius = 1;

    Sphere shape() const { return {}; }
    glm::dmat4 placeIn(const glm::dmat4& around) const { return shapePlace(around, centre, glm::dvec3(radius)); }
    std::string text() const { return nodeText(centre, radius); }
};

}  // namespace gr
