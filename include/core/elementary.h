// Logarithm and exponential. Ours, so that every machine and every width gives the same bits, which the C library does
// not promise.
#pragma once

#include "core/lanes.h"

#include <bit>
#include <cstdint>

namespace core {

// x = mantissa * 2^exponent, the mantissa in [sqrt(1/2), sqrt(2)); for normal x > 0.
template<class Real>
struct Binary {
    Real mantissa, exponent;
};

inline constexpr std::int32_t bitsOfHalfsRoot = 0x3f3504f3;

inline Binary<float> binaryOf(float x) {
    const std::int32_t bits = std::bit_cast<std::int32_t>(x);
    const std::int32_t exponent = (bits - bitsOfHalfsRoot) >> 23;
    return {std::bit_cast<float>(bits - exponent * (1 << 23)), static_cast<float>(exponent)};
}
template<class Arch>
Binary<xsimd::batch<float, Arch>> binaryOf(xsimd::batch<float, Arch> x) {
    using Int = xsimd::batch<std::int32_t, Arch>;
    const Int bits = xsimd::bitwise_cast<Int>(x);
    const Int exponent = (bits - Int(bitsOfHalfsRoot)) >> 23;
    return {xsimd::bitwise_cast<xsimd::batch<float, Arch>>(bits - (exponent << 23)), xsimd::to_float(exponent)};
}

// 2^n for a whole n from -126 to 127.
inline float powerOfTwo(float n) {
    return std::bit_cast<float>((static_cast<std::int32_t>(n) + 127) * (1 << 23));
}
template<class Arch>
xsimd::batch<float, Arch> powerOfTwo(xsimd::batch<float, Arch> n) {
    using Int = xsimd::batch<std::int32_t, Arch>;
    return xsimd::bitwise_cast<xsimd::batch<float, Arch>>((xsimd::to_int(n) + Int(127)) << 23);
}

// ln 2 in two parts: a whole number of up to 8 bits times the first is exact.
inline constexpr float ln2High = 0.693359375f;
inline constexpr float ln2Low = -2.12194440e-4f;

// ln x for normal x > 0, to two units in the last place also near 1:
// ln m = 2 artanh(s) with s = (m - 1) / (m + 1), |s| < 0.172.
template<class Real>
Real log(Real x) {
    const Binary<Real> b = binaryOf(x);
    const Real s = (b.mantissa - Real(1)) / (b.mantissa + Real(1));
    const Real s2 = s * s;
    const Real tail = s2 * (Real(1 / 3.f) + s2 * (Real(1 / 5.f) + s2 * (Real(1 / 7.f) + s2 * Real(1 / 9.f))));
    const Real logMantissa = Real(2) * (s + s * tail);
    return b.exponent * Real(ln2High) + (b.exponent * Real(ln2Low) + logMantissa);
}

// e^x = 2^n (1 + p): n whole, and p = e^r - 1 for the rest |r| <= ln(2) / 2.
template<class Real>
struct Exponential {
    Real scale, p;  // 2^n, p
};

// x is taken to be at least -87, where e^x is hardly more than the smallest normal number, and at most 88.
template<class Real>
Exponential<Real> exponential(Real x) {
    const Real clamped = min(max(x, Real(-87)), Real(88));
    constexpr float roundsToWhole = 0x1.8p23f;
    const Real n = (clamped * Real(1.44269504f) + Real(roundsToWhole)) - Real(roundsToWhole);
    const Real r = (clamped - n * Real(ln2High)) - n * Real(ln2Low);
    const Real tail = Real(1 / 24.f) + r * (Real(1 / 120.f) + r * (Real(1 / 720.f) + r * Real(1 / 5040.f)));
    const Real p = r + r * r * (Real(1 / 2.f) + r * (Real(1 / 6.f) + r * tail));
    return {powerOfTwo(n), p};
}

// e^x; 0 below e^-87. Not beyond x = 88.
template<class Real>
Real exp(Real x) {
    // Numbers below the normal ones, which would come up at the end of the range, make processors slow.
    const auto vanishes = x < Real(-87);
    const Exponential<Real> e = exponential(select(vanishes, Real(0), x));
    return select(vanishes, Real(0), e.scale + e.scale * e.p);
}

// e^x - 1, also near 0 to all its digits.
template<class Real>
Real expm1(Real x) {
    const Exponential<Real> e = exponential(x);
    return e.scale * e.p + (e.scale - Real(1));
}

// The angle of the direction (x, y), from -pi to pi, to 2^-22; 0 for no direction.
// The ratio is brought down to |r| <= tan(pi / 8) by tan(a - pi / 4) = (r - 1) / (r + 1), for which eight terms of
// arctan's series are enough.
template<class Real>
Real atan2(Real y, Real x) {
    const Real zero(0), one(1), quarterPi(0.785398163397448f);
    const Real width = abs(x), height = abs(y);
    const auto isSteep = height > width;
    const Real small = select(isSteep, width, height), large = select(isSteep, height, width);
    const Real ratio = small / select(large > zero, large, one);
    const auto isWide = ratio > Real(0.414213562f);
    const Real r = select(isWide, (ratio - one) / (ratio + one), ratio), r2 = r * r;
    Real tail = Real(-1 / 15.f);
    for (const float odd : {13.f, -11.f, 9.f, -7.f, 5.f, -3.f}) tail = tail * r2 + Real(1 / odd);
    const Real angle = select(isWide, quarterPi, zero) + (r + r * r2 * tail);
    const Real inQuadrant = select(isSteep, quarterPi * Real(2) - angle, angle);
    const Real above = select(x < zero, quarterPi * Real(4) - inQuadrant, inQuadrant);
    return select(y < zero, -above, above);
}

}  // namespace core
