// From the unit square to where directions are: each warp stands beside its density.
#pragma once

#include "core/vec.h"

namespace core {

template<class Real>
struct SinCos {
    Real sin, cos;
};

// Sine and cosine of an angle in turns, 0 <= turns <= 1. Ours, so that every machine and every width gives the same
// bits, which the C library does not promise.
// The angle is brought to [-1/8, 1/8] turns round the nearest quarter k, where the Taylor series to x^9 and x^8
// are exact to less than half a unit in the last place.
template<class Real>
SinCos<Real> sinCosTurns(Real turns) {
    const Real k = wholePart(turns * Real(4) + Real(0.5f));
    const Real x = (turns - k * Real(0.25f)) * Real(2 * pi);
    const Real x2 = x * x;
    const Real sine =
        x + x * x2 * (Real(-1 / 6.f) + x2 * (Real(1 / 120.f) + x2 * (Real(-1 / 5040.f) + x2 * Real(1 / 362880.f))));
    const Real cosine =
        Real(1) + x2 * (Real(-1 / 2.f) + x2 * (Real(1 / 24.f) + x2 * (Real(-1 / 720.f) + x2 * Real(1 / 40320.f))));

    const Mask<Real> odd = (k == Real(1)) | (k == Real(3));
    const Mask<Real> sineTurned = (k == Real(2)) | (k == Real(3));
    const Mask<Real> cosineTurned = (k == Real(1)) | (k == Real(2));
    const Real s = select(odd, cosine, sine);
    const Real c = select(odd, sine, cosine);
    return {select(sineTurned, -s, s), select(cosineTurned, -c, c)};
}

// Uniform over the directions with z >= 0 (Archimedes: equal heights of the sphere have equal areas).
template<class Real>
Vec3<Real> squareToUniformHemisphere(const Vec2<Real>& u) {
    const Real z = u.x;
    const Real radius = sqrt(max(Real(0), Real(1) - z * z));
    const SinCos<Real> phi = sinCosTurns(u.y);
    return {radius * phi.cos, radius * phi.sin, z};
}

template<class Real>
Real uniformHemispherePdfW(const Vec3<Real>& direction) {
    return select(direction.z >= Real(0), Real(1 / (2 * pi)), Real(0));
}

// With a density in proportion to the cosine: what is uniform over the disc below, lifted onto the hemisphere (Malley).
template<class Real>
Vec3<Real> squareToCosineHemisphere(const Vec2<Real>& u) {
    const Real radius = sqrt(u.x);
    const SinCos<Real> phi = sinCosTurns(u.y);
    return {radius * phi.cos, radius * phi.sin, sqrt(Real(1) - u.x)};
}

template<class Real>
Real cosineHemispherePdfW(const Vec3<Real>& direction) {
    return max(direction.z, Real(0)) * Real(1 / pi);
}

// The two as what a template may be asked to draw from.
struct UniformHemisphere {
    template<class Real>
    static Vec3<Real> direction(const Vec2<Real>& u) {
        return squareToUniformHemisphere(u);
    }
    template<class Real>
    static Real pdfW(const Vec3<Real>& direction) {
        return uniformHemispherePdfW(direction);
    }
};
struct CosineHemisphere {
    template<class Real>
    static Vec3<Real> direction(const Vec2<Real>& u) {
        return squareToCosineHemisphere(u);
    }
    template<class Real>
    static Real pdfW(const Vec3<Real>& direction) {
        return cosineHemispherePdfW(direction);
    }
};

// Uniform over the unit disc: the square root makes up for rings that grow with their radius.
template<class Real>
Vec2<Real> squareToUniformDisc(const Vec2<Real>& u) {
    const Real radius = sqrt(u.x);
    const SinCos<Real> phi = sinCosTurns(u.y);
    return {radius * phi.cos, radius * phi.sin};
}

template<class Real>
Real uniformDiscPdfA(const Vec2<Real>& place) {
    return select(place.x * place.x + place.y * place.y <= Real(1), Real(1 / pi), Real(0));
}

// A cone is told by its height: 1 - the cosine of its half angle, 2 sin^2 of half of that, which keeps its digits in
// narrow cones. Uniform over the directions in it, about the z axis.
template<class Real>
Vec3<Real> squareToUniformCone(const Vec2<Real>& u, Real height) {
    const Real depth = u.x * height;
    const Real radius = sqrt(max(Real(0), depth * (Real(2) - depth)));
    const SinCos<Real> phi = sinCosTurns(u.y);
    return {radius * phi.cos, radius * phi.sin, Real(1) - depth};
}

// axis, direction: of unit length. The square of the chord between them is 2 (1 - cos). The cone is a hair wider than
// what is drawn, for what rounding may add.
template<class Real>
Real uniformConePdfW(const Vec3<Real>& axis, const Vec3<Real>& direction, Real height) {
    const Vec3<Real> chord = direction - axis;
    const Mask<Real> inside = glm::dot(chord, chord) <= Real(2) * height * Real(1 + 0x1p-16f) + Real(0x1p-44f);
    return select(inside, Real(1 / (2 * pi)) / height, Real(0));
}

// A density over solid angle from one over area: the area dA at the end of a line of the given length, with
// cosine to its normal, fills the solid angle dA * cosine / distance^2.
template<class Real>
Real pdfAtoW(Real pdfA, Real distanceSquared, Real cosine) {
    return pdfA * distanceSquared / cosine;
}

}  // namespace core
