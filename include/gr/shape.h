// THE list of shapes, in their own space. To add one: write its struct here, with intersect over Real and surfaceAt,
// and add it to Shape.
// intersect returns the smallest t with 0 < t < ray.tMax at which the ray meets the shape, or infinity. Where a ray
// starts is decided by signs that rounding cannot turn, so that one which starts a hair outside stays outside.
// surfaceAt keeps the point `margin` away from the edges of its face, along each axis: far enough for a ray that goes
// on from there, a hair off the face, to start on the same side of the faces beyond the edges.
#pragma once

#include "core/ray.h"
#include "gr/polyhedron.h"

#include <variant>

namespace gr {

// Where a ray met something.
template<class Real>
struct HitOf {
    Real t = Real(core::infinity);  // infinity: nowhere
    core::UInt<Real> instance = core::UInt<Real>(0);  // index into Scene::instances
    core::UInt<Real> triangle = core::UInt<Real>(0);  // for a polyhedron: which one,
    Real b1 = Real(0), b2 = Real(0);  // and the weights of its second and third vertex

    // Where two surfaces coincide the one made first is hit, in whatever order they are tested.
    bool isBefore(const HitOf& other) const {
        if (t != other.t) return t < other.t;
        return instance != other.instance ? instance < other.instance : triangle < other.triangle;
    }
};
using Hit = HitOf<float>;

// A point of a surface and the outward normal (not of unit length) there, in the shape's own space.
template<class Real>
struct ShapePoint {
    core::Vec3<Real> position;
    core::Vec3<Real> normal;
    core::Mask<Real> front;  // whether the ray came from the side of the normal, also where rounding hides it
};

// The unit sphere at the origin.
struct Sphere {
    static constexpr float extent = 1;  // the largest coordinate of any of its points

    // Haines et al., "Precision Improvements for Ray/Sphere Intersection" (Ray Tracing Gems, 2019): the discriminant
    // from the point of the line nearest to the centre, and both roots without cancellation.
    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        using core::select;
        const Real a = glm::dot(ray.direction, ray.direction);
        const Real b = -glm::dot(ray.origin, ray.direction);
        const core::Vec3<Real> nearest = ray.origin + ray.direction * (b / a);
        const Real discriminant = Real(1) - glm::dot(nearest, nearest);
        const core::Mask<Real> meets = discriminant >= Real(0);
        const Real root = core::sqrt(a * core::max(discriminant, Real(0)));
        const Real q = b + select(b < Real(0), -root, root);  // not copysign: lanes may differ in the sign of a zero
        const Real c = glm::dot(ray.origin, ray.origin) - Real(1);
        const Real t1 = c / q;
        const Real t2 = q / a;
        const Real enter = core::min(t1, t2);
        const Real leave = core::max(t1, t2);
        const Real t = select(enter > Real(0), enter, leave);
        return select(meets & (t > Real(0)) & (t < ray.tMax), t, Real(core::infinity));
    }

    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>& margin) const {
        const core::Vec3<Real> p = glm::normalize(ray.origin + ray.direction * t);
        const core::Mask<Real> front = glm::dot(ray.origin, ray.origin) - Real(1) > Real(0);
        // Seen from within, the sphere comes nearer sideways, by half the square of how far.
        const Real sagitta = core::min(Real(0.5f) * glm::dot(margin, margin), Real(0.5f));
        return {core::select(front, p, p * (Real(1) - sagitta)), p, front};
    }
};

// The box [0, 1]^3.
struct Box {
    static constexpr float extent = 1;

    // Slabs (Kay and Kajiya 1986). A ray inside a face's plane makes 0 / 0; min and max then keep the bound so far.
    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        using core::select;
        Real enter(-core::infinity);
        Real leave(core::infinity);
        for (int axis = 0; axis < 3; ++axis) {
            const Real inverse = Real(1) / ray.direction[axis];
            const Real t0 = -ray.origin[axis] * inverse;
            const Real t1 = (Real(1) - ray.origin[axis]) * inverse;
            const core::Mask<Real> upwards = inverse > Real(0);
            enter = core::max(select(upwards, t0, t1), enter);
            leave = core::min(select(upwards, t1, t0), leave);
        }
        // Three roundings (Ize, "Robust BVH Ray Traversal", 2013): a ray along an edge does not slip between two slabs.
        const core::Mask<Real> meets = enter <= leave * Real(1 + 4 * 0x1p-23f);
        const Real t = select(enter > Real(0), enter, leave);
        return select(meets & (t > Real(0)) & (t < ray.tMax), t, Real(core::infinity));
    }

    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>& margin) const {
        const Real zero(0), one(1);
        const auto isBeyond = [&](int i) { return (ray.origin[i] < zero) | (ray.origin[i] > one); };
        const core::Mask<Real> outside = isBeyond(0) | isBeyond(1) | isBeyond(2);
        // The face is the nearest of those that a ray from there can meet: never one that looks the other way, however
        // near the edge to it.
        const core::Vec3<Real> hit = ray.origin + ray.direction * t;
        core::Vec3<Real> plane, distance;
        for (int i = 0; i < 3; ++i) {
            plane[i] = core::select(core::differ(ray.direction[i] > zero, outside), one, zero);
            distance[i] = core::abs(hit[i] - plane[i]);
        }
        const core::Mask<Real> isY = distance.y < distance.x;
        const core::Mask<Real> isZ = distance.z < core::select(isY, distance.y, distance.x);
        const core::Mask<Real> isX = !(isY | isZ), isOnlyY = isY & !isZ;
        const core::Mask<Real> isFace[3] = {isX, isOnlyY, isZ};
        core::Vec3<Real> position, normal;
        for (int i = 0; i < 3; ++i) {
            const Real least = core::min(margin[i], Real(0.5f));
            const Real inside = core::min(core::max(hit[i], least), one - least);
            position[i] = core::select(isFace[i], plane[i], inside);
            normal[i] = core::select(isFace[i], Real(2) * plane[i] - one, zero);
        }
        return {position, normal, outside};
    }
};

// The square [-1/2, 1/2]^2 in the x-z plane, facing -y: an area light.
struct Square {
    static constexpr float extent = 0.5f;

    std::uint32_t light = 0;  // index into the area lights of Scene::lights

    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        const Real t = -ray.origin.y / ray.direction.y;
        const Real x = ray.origin.x + ray.direction.x * t;
        const Real z = ray.origin.z + ray.direction.z * t;
        const core::Mask<Real> inside = (core::abs(x) <= Real(0.5f)) & (core::abs(z) <= Real(0.5f));
        return core::select(inside & (t > Real(0)) & (t < ray.tMax), t, Real(core::infinity));
    }

    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>&) const {
        const core::Vec3<Real> p = ray.origin + ray.direction * t;
        return {{p.x, Real(0), p.z}, {Real(0), Real(-1), Real(0)}, ray.direction.y > Real(0)};
    }
};

// A polyhedron is shared by all its instances; the scene owns it. Size and place of the others are their instance's.
using Shape = std::variant<const Polyhedron*, Sphere, Box, Square>;

}  // namespace gr
