// The one place where a ray meets a triangle.
#pragma once

#include "core/ray.h"

namespace gr {

// Which part of a triangle a ray goes through.
template<class Real>
struct TriangleCrossing {
    core::Mask<Real> inside;
    Real u, v, w;  // the areas opposite to the three vertices, all of them times the same factor
};

template<class Real>
TriangleCrossing<Real> select(const core::Mask<Real>& mask, const TriangleCrossing<Real>& yes,
                              const TriangleCrossing<Real>& no) {
    return {(mask & yes.inside) | (no.inside & !mask), core::select(mask, yes.u, no.u), core::select(mask, yes.v, no.v),
            core::select(mask, yes.w, no.w)};
}

// What is lost when a * b is rounded to `product` (Dekker 1971): the factors are split into halves whose products are
// exact.
template<class Real>
Real lostFrom(Real product, Real a, Real b) {
    const Real splitter(0x1p12f + 1);
    const Real aHigh = splitter * a - (splitter * a - a), aLow = a - aHigh;
    const Real bHigh = splitter * b - (splitter * b - b), bLow = b - bHigh;
    return ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
}

// a * b - c * d to the last bit or two.
template<class Real>
Real differenceOfProducts(Real a, Real b, Real c, Real d) {
    const Real ab = a * b, cd = c * d;
    return (ab - cd) + (lostFrom(ab, a, b) - lostFrom(cd, c, d));
}

#ifdef __FMA__
// a * b - c, rounded once. xsimd rounds twice where it takes lanes for those of an older processor.
template<class Lanes>
Lanes fusedDifference(const Lanes& a, const Lanes& b, const Lanes& c) {
    constexpr int lanes = core::laneCount<Lanes>;
    static_assert(lanes == 4 || lanes == 8 || lanes == 16);
#ifdef __AVX512F__
    if constexpr (lanes == 16) return _mm512_fmsub_ps(a.data, b.data, c.data);
#endif
    if constexpr (lanes == 8) return _mm256_fmsub_ps(a.data, b.data, c.data);
    if constexpr (lanes == 4) return _mm_fmsub_ps(a.data, b.data, c.data);
}

// The same bits as differenceOfProducts has, in far less time, where mayBeFused says so: both ways tell what a product
// loses without error, and nothing as +0.
template<class Lanes>
Lanes fusedDifferenceOfProducts(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
    const Lanes ab = a * b, cd = c * d;
    return (ab - cd) + (fusedDifference(a, b, ab) - fusedDifference(c, d, cd));
}
// Whether all numbers are so large that what their products lose, of which the last digit is worth no less than the
// product of theirs, 2^-148, is a number of single precision; and so small that Dekker's halves do not overflow.
template<class Lanes>
bool mayBeFused(const core::Vec2<Lanes>& a, const core::Vec2<Lanes>& b, const core::Vec2<Lanes>& c) {
    const Lanes size[] = {core::abs(a.x), core::abs(a.y), core::abs(b.x),
                          core::abs(b.y), core::abs(c.x), core::abs(c.y)};
    Lanes least = size[0], most = size[0];
    for (int i = 1; i < 6; ++i) {
        least = xsimd::min(least, size[i]);
        most = xsimd::max(most, size[i]);
    }
    return core::all((least >= Lanes(0x1p-51f)) & (most <= Lanes(0x1p60f)));
}
#endif

template<class Real>
struct TriangleHit {
    Real t;  // infinity where the ray misses
    Real b1, b2;  // weights of the second and the third vertex at the hit
};

// The axes in another order, a ray's longest one last: the same order in all lanes,
struct UniformAxes {
    int x, y, z;

    explicit UniformAxes(const core::Vec3f& direction) {
        const core::Vec3f size = glm::abs(direction);
        *this = UniformAxes(size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2);
    }
    explicit UniformAxes(int last) : x(last == 2 ? 0 : last + 1), y(last == 0 ? 2 : last - 1), z(last) {}
    template<class Real>
    core::Vec3<Real> permute(const core::Vec3<Real>& v) const {
        return {v[x], v[y], v[z]};
    }
};

// or an order for each lane.
template<class Real>
struct LaneAxes {
    core::Mask<Real> xLast, yLast;

    explicit LaneAxes(const core::Vec3<Real>& direction) {
        const core::Vec3<Real> size = {core::abs(direction.x), core::abs(direction.y), core::abs(direction.z)};
        xLast = (size.x >= size.y) & (size.x >= size.z);
        yLast = (size.y >= size.z) & !xLast;
    }
    core::Vec3<Real> permute(const core::Vec3<Real>& v) const {
        const auto pick = [&](const Real& ifX, const Real& ifY, const Real& ifZ) {
            return core::select(xLast, ifX, core::select(yLast, ifY, ifZ));
        };
        return {pick(v.y, v.z, v.x), pick(v.z, v.x, v.y), pick(v.x, v.y, v.z)};
    }
};

template<class Real>
using AxesOf = std::conditional_t<std::is_same_v<Real, float>, UniformAxes, LaneAxes<Real>>;

// A ray made ready to be tested against many triangles.
// Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013): space is sheared so that the ray becomes the
// last axis. Each vertex is sheared in the same way for all triangles that share it, and each edge is decided by the
// sign of one difference of products, which rounding can make 0 but never turn; 0 counts as inside on both sides. So no
// ray slips between two triangles. Contracting that difference into a fused multiply-add would break this: the build
// forbids it.
template<class Real, class Axes = AxesOf<Real>>
struct TriangleRay {
    Axes axes;
    core::Vec3<Real> origin;  // permuted
    Real slopeX, slopeY, scale;  // the shear, and what makes t of the last coordinate
    Real tMax;

    explicit TriangleRay(const core::Ray<Real>& ray)
        : axes(ray.direction), origin(axes.permute(ray.origin)), tMax(ray.tMax) {
        const core::Vec3<Real> d = axes.permute(ray.direction);
        scale = Real(1) / d.z;
        slopeX = d.x * scale;
        slopeY = d.y * scale;
    }

    TriangleRay(const Axes& axes, const core::Vec3<Real>& origin, const Real& slopeX, const Real& slopeY,
                const Real& scale, const Real& tMax)
        : axes(axes), origin(origin), slopeX(slopeX), slopeY(slopeY), scale(scale), tMax(tMax) {}

    // The same ray in every lane.
    template<class One>
    requires(std::is_same_v<One, float> &&
             !std::is_same_v<Real, float>) explicit TriangleRay(const TriangleRay<One>& ray)
        : axes(ray.axes),
          origin(core::broadcast<Real>(ray.origin)),
          slopeX(ray.slopeX),
          slopeY(ray.slopeY),
          scale(ray.scale),
          tMax(ray.tMax) {}

    // Vertices are permuted ones here, in exactCross and in hit.
    TriangleCrossing<Real> cross(const core::Vec3<Real>& v0, const core::Vec3<Real>& v1,
                                 const core::Vec3<Real>& v2) const {
        const core::Vec2<Real> a = sheared(v0), b = sheared(v1), c = sheared(v2);
        return crossingOf(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
    }

    // The areas of a thin triangle, or of a small one far from the ray, are small differences of large products. With
    // what the products lose by rounding, t, which is a mean weighted by the areas, would be so far off that a ray met
    // the triangle that it has just left; and all areas could be 0, or one of them not, where the ray passes by at a
    // distance. Signs that are not 0 in `cross` are the same here.
    TriangleCrossing<Real> exactCross(const core::Vec3<Real>& v0, const core::Vec3<Real>& v1,
                                      const core::Vec3<Real>& v2) const {
        const core::Vec2<Real> a = sheared(v0), b = sheared(v1), c = sheared(v2);
#ifdef __FMA__
        if constexpr (!std::is_same_v<Real, float>)
            if (mayBeFused(a, b, c))
                return crossingOf(fusedDifferenceOfProducts(c.x, b.y, c.y, b.x),
                                  fusedDifferenceOfProducts(a.x, c.y, a.y, c.x),
                                  fusedDifferenceOfProducts(b.x, a.y, b.y, a.x));
#endif
        return crossingOf(differenceOfProducts(c.x, b.y, c.y, b.x), differenceOfProducts(a.x, c.y, a.y, c.x),
                          differenceOfProducts(b.x, a.y, b.y, a.x));
    }

    // t as the mean of the vertices', weighted by the areas. A triangle seen edge-on has no area and is missed.
    TriangleHit<Real> hit(const TriangleCrossing<Real>& crossing, const core::Vec3<Real>& v0,
                          const core::Vec3<Real>& v1, const core::Vec3<Real>& v2) const {
        const Real area = crossing.u + crossing.v + crossing.w;
        const Real inverse = Real(1) / area;
        const Real sum =
            crossing.u * (v0.z - origin.z) + crossing.v * (v1.z - origin.z) + crossing.w * (v2.z - origin.z);
        const Real t = sum * scale * inverse;
        const core::Mask<Real> hits = crossing.inside & (area != Real(0)) & (t > Real(0)) & (t < tMax);
        return {core::select(hits, t, Real(core::infinity)), crossing.v * inverse, crossing.w * inverse};
    }

    TriangleHit<Real> intersect(const core::Vec3<Real>& v0, const core::Vec3<Real>& v1,
                                const core::Vec3<Real>& v2) const {
        const core::Vec3<Real> a = axes.permute(v0), b = axes.permute(v1), c = axes.permute(v2);
        return hit(cross(a, b, c), a, b, c);
    }

    // A permuted vertex, seen along the ray: across it.
    core::Vec2<Real> sheared(const core::Vec3<Real>& vertex) const {
        const core::Vec3<Real> a = vertex - origin;
        return {a.x - slopeX * a.z, a.y - slopeY * a.z};
    }

private:
    static TriangleCrossing<Real> crossingOf(const Real& u, const Real& v, const Real& w) {
        const Real zero(0);
        const core::Mask<Real> inside =
            ((u >= zero) & (v >= zero) & (w >= zero)) | ((u <= zero) & (v <= zero) & (w <= zero));
        return {inside, u, v, w};
    }
};

}  // namespace gr
