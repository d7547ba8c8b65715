// What a shape tells of a place on its surface, in the shape's own space, and the words that shapes tell it with.
#pragma once

#include "core/elementary.h"
#include "core/ray.h"
#include "core/transform.h"

namespace gr {

// A point of a surface and the outward normal (not of unit length) there.
template<class Real>
struct ShapePoint {
    core::Vec3<Real> position;
    core::Vec3<Real> normal;
    core::Mask<Real> front;  // whether the ray came from the side of the normal, also where rounding hides it
};

// Where that is on the surface. As seen from outside with y upwards, u grows to the right and v upwards.
template<class Real>
struct Coordinates {
    core::Vec2<Real> uv;
    core::Vec3<Real> tangent;  // in which u grows, not of unit length; it is the same all over a flat face
};

// A part of a line that is inside a solid, from `enter` to `leave`, or nowhere.
template<class Real>
struct Interval {
    Real enter, leave;
    core::Mask<Real> exists;

    // The smallest t at which the ray goes in or out, or infinity.
    Real first(const core::Ray<Real>& ray) const {
        const Real t = core::select(enter > Real(0), enter, leave);
        return core::select(exists & (t > Real(0)) & (t < ray.tMax), t, Real(core::infinity));
    }
};

// To the east, y being the axis, and along x where the normal is that axis: it has no seam on what is round.
template<class Real>
core::Vec3<Real> eastOf(const core::Vec3<Real>& normal) {
    const Real beyondRounding(0x1p-17f), zero(0);
    const core::Mask<Real> isPole = core::abs(normal.x) + core::abs(normal.z) <= beyondRounding * core::abs(normal.y);
    return core::select(isPole, core::Vec3<Real>(Real(1), zero, zero), {normal.z, zero, -normal.x});
}

// Round the y axis from its -z side, where it is 0, by way of -x, +z (1/2) and +x to 1: to the east.
template<class Real>
Real longitudeOf(const core::Vec3<Real>& p) {
    return Real(0.5f) + core::atan2<Real>(p.x, p.z) * Real(0.5f / core::pi);
}

// On a flat face: its own units to the east and to the north.
template<class Real>
Coordinates<Real> flatCoordinates(const core::Vec3<Real>& position, const core::Vec3<Real>& normal) {
    const core::Vec3<Real> n = glm::normalize(normal), east = glm::normalize(eastOf<Real>(n));
    return {{glm::dot(position, east), glm::dot(position, glm::cross(n, east))}, east};
}

// How far a box about the origin reaches along the world's axes. half: half its size.
inline core::Vec3f reachOfBox(const core::Transform& map, const core::Vec3f& half) {
    return glm::abs(map.x) * half.x + glm::abs(map.y) * half.y + glm::abs(map.z) * half.z;
}

}  // namespace gr
