// Where rays met triangles of a polyhedron, for each lane.
#pragma once

#include "gr/mesh/pack.h"

namespace gr {

// The packs are nothing but floats, so that lanes can gather a triangle's from them.
template<class Real>
core::Vec3<Real> Polyhedron::cornerOf(const core::UInt<Real>& triangle, int corner) const {
    using UInt = core::UInt<Real>;
    static_assert(packWidth == 4 && sizeof(TrianglePack) == 36 * sizeof(float));
    const UInt first = (triangle >> 2) * UInt(36) + (triangle & UInt(3));
    const float* floats = &packs_[0].vertex[corner][0][0];
    const auto axis = [&](int k) { return core::gather(floats + packWidth * k, first); };
    return {axis(0), axis(1), axis(2)};
}

template<class Real>
ShapePoint<Real> Polyhedron::surfaceAt(const core::Ray<Real>& ray, const HitOf<Real>& hit,
                                       const core::Vec3<Real>& margin) const {
    const core::Vec3<Real> a = cornerOf<Real>(hit.triangle, 0), b = cornerOf<Real>(hit.triangle, 1),
                           c = cornerOf<Real>(hit.triangle, 2);
    // To the last bits: rounded, a thin triangle's normal would be turned along it by more than the offset allows for.
    const core::Vec3<Real> e = b - a, f = c - a;
    const core::Vec3<Real> normal(differenceOfProducts(e.y, f.z, e.z, f.y), differenceOfProducts(e.z, f.x, e.x, f.z),
                                  differenceOfProducts(e.x, f.y, e.y, f.x));
    // A vertex's weight is the distance from the edge opposite over the height above it; the smallest height stands on
    // the longest edge. To be clear of the face beyond an edge takes 1 / sin(angle) times the margin where they meet at
    // an acute angle: 4 is enough for 15 degrees.
    const core::Vec3<Real> g = c - b;
    const Real longest = core::max(core::max(Real(glm::dot(e, e)), Real(glm::dot(g, g))), Real(glm::dot(f, f)));
    const Real square = glm::dot(margin, margin) * longest / glm::dot(normal, normal);
    const Real least = core::min(Real(4) * core::sqrt(square), Real(0.25f));
    const Real b0 = core::max(Real(1) - hit.b1 - hit.b2, least);
    const Real b1 = core::max(hit.b1, least), b2 = core::max(hit.b2, least);
    const core::Vec3<Real> position = (a * b0 + b * b1 + c * b2) / (b0 + b1 + b2);
    return {position, normal, glm::dot(ray.direction, normal) < Real(0)};
}

template<class Real>
core::Vec3<Real> Polyhedron::normalOf(const core::UInt<Real>& triangle, int corner) const {
    using UInt = core::UInt<Real>;
    const auto* packed = reinterpret_cast<const float*>(normals_.data());
    const UInt place = triangle * UInt(3) + UInt(static_cast<std::uint32_t>(corner));
    return unpackNormal<Real>(core::bitsAsUInt(core::gather(packed, place)));
}

template<class Real>
core::Vec3<Real> Polyhedron::shadingNormal(const HitOf<Real>& hit) const {
    const core::UInt<Real>& triangle = hit.triangle;
    return normalOf<Real>(triangle, 0) * (Real(1) - hit.b1 - hit.b2) + normalOf<Real>(triangle, 1) * hit.b1 +
           normalOf<Real>(triangle, 2) * hit.b2;
}

template<class Real>
core::Vec2<Real> Polyhedron::uvAt(const HitOf<Real>& hit) const {
    const float* numbers = &uvs_[0].x;
    const core::UInt<Real> first = hit.triangle * core::UInt<Real>(6);
    const auto corner = [&](std::uint32_t k, std::uint32_t axis) {
        return core::gather(numbers, core::UInt<Real>(first + core::UInt<Real>(2 * k + axis)));
    };
    const auto along = [&](std::uint32_t axis) {
        return corner(0, axis) * (Real(1) - hit.b1 - hit.b2) + corner(1, axis) * hit.b1 + corner(2, axis) * hit.b2;
    };
    return {along(0), along(1)};
}

template<class Real>
core::Vec3<Real> Polyhedron::lift(const HitOf<Real>& hit, const ShapePoint<Real>& point) const {
    const Real zero(0), weights[] = {Real(1) - hit.b1 - hit.b2, hit.b1, hit.b2};
    const Real side = core::select(point.front, Real(1), Real(-1));
    core::Vec3<Real> lift(zero);
    for (int k = 0; k < 3; ++k) {
        const core::Vec3<Real> normal = normalOf<Real>(hit.triangle, k);
        const Real height = glm::dot(cornerOf<Real>(hit.triangle, k) - point.position, normal) * side;
        // A normal on the other side of its face would lead through it.
        const core::Mask<Real> counts = (height > zero) & (glm::dot(normal, point.normal) > zero);
        lift += normal * core::select(counts, height * side * core::max(weights[k], zero), zero);
    }
    return lift;
}

}  // namespace gr
