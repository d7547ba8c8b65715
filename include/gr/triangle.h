// The one place where a ray meets a triangle.
#pragma once

#include "core/ray.h"

namespace gr {

template<class Real>
struct TriangleHit {
    Real t;  // infinity where the ray misses
    Real b1, b2;  // weights of the second and the third vertex at the hit
};

// A ray made ready to be tested against many triangles: two axes that look along the ray, so that in them the ray is
// the point 0, and one that measures t.
// Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013): each vertex is projected in the same way
// for all triangles that share it, and each edge is decided by the sign of one difference of products, which rounding
// can make 0 but never turn; 0 counts as inside on both sides. So no ray slips between two triangles.
// Contracting that difference into a fused multiply-add would break this: the build forbids it.
template<class Real>
struct TriangleRay {
    core::Vec3<Real> origin, across1, across2, along;
    Real tMax;

    explicit TriangleRay(const core::Ray<Real>& ray) : origin(ray.origin), tMax(ray.tMax) {
        using core::select;
        const core::Vec3<Real> d = ray.direction;
        const core::Vec3<Real> size = {core::abs(d.x), core::abs(d.y), core::abs(d.z)};
        const core::Mask<Real> xLargest = (size.x >= size.y) & (size.x >= size.z);
        const core::Mask<Real> yLargest = (size.y > size.x) & (size.y >= size.z);
        const Real zero(0), one(1);

        // Shear along the direction's largest axis: the two others stay as they are.
        const Real largest = select(xLargest, d.x, select(yLargest, d.y, d.z));
        const core::Vec3<Real> slope = -d / largest;
        across1 = {select(xLargest, slope.y, one), select(xLargest, one, select(yLargest, slope.x, zero)),
                   select(xLargest | yLargest, zero, slope.x)};
        across2 = {select(xLargest, slope.z, zero), select(xLargest, zero, select(yLargest, slope.z, one)),
                   select(xLargest | yLargest, one, slope.y)};
        along = d / glm::dot(d, d);
    }

    TriangleHit<Real> intersect(const core::Vec3<Real>& v0, const core::Vec3<Real>& v1,
                                const core::Vec3<Real>& v2) const {
        const core::Vec3<Real> a = v0 - origin, b = v1 - origin, c = v2 - origin;
        const Real ax = glm::dot(a, across1), ay = glm::dot(a, across2);
        const Real bx = glm::dot(b, across1), by = glm::dot(b, across2);
        const Real cx = glm::dot(c, across1), cy = glm::dot(c, across2);

        // Twice the areas of the triangles between the ray and each edge.
        const Real u = cx * by - cy * bx;
        const Real v = ax * cy - ay * cx;
        const Real w = bx * ay - by * ax;
        const Real zero(0);
        const core::Mask<Real> inside =
            ((u >= zero) & (v >= zero) & (w >= zero)) | ((u <= zero) & (v <= zero) & (w <= zero));
        const Real area = u + v + w;
        const Real inverse = Real(1) / area;
        const Real t = (u * glm::dot(a, along) + v * glm::dot(b, along) + w * glm::dot(c, along)) * inverse;
        const core::Mask<Real> hits = inside & (area != zero) & (t > zero) & (t < tMax);
        return {core::select(hits, t, Real(core::infinity)), v * inverse, w * inverse};
    }
};

}  // namespace gr
