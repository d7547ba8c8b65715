// The whole number below a number, for places on a lattice.
#pragma once

#include "core/lanes.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace core {

inline float floor(float x) {
    return std::floor(x);
}
template<class Arch>
xsimd::batch<float, Arch> floor(const xsimd::batch<float, Arch>& x) {
    return xsimd::floor(x);
}

// A whole number of at most 2^30 with a sign as one without, modulo 2^32.
inline std::uint32_t wrapped(float x) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(x));
}
template<class Arch>
xsimd::batch<std::uint32_t, Arch> wrapped(const xsimd::batch<float, Arch>& x) {
    return xsimd::bitwise_cast<xsimd::batch<std::uint32_t, Arch>>(xsimd::to_int(x));
}

// x as a whole number and what is left, from 0 to 1 without 1. Beyond 2^30 all are the last one's: there floats tell
// no such numbers apart.
template<class Real>
struct Whole {
    UInt<Real> number;  // modulo 2^32
    Real rest;

    explicit Whole(const Real& x) {
        const Real most(0x1p30f), inside = min(max(x, -most), most), below = floor(inside);
        number = wrapped(below);
        rest = min(inside - below, Real(1 - 0x1p-24f));
    }
};

}  // namespace core
