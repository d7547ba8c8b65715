// Real numbers, one or many at a time. Everything that computes light is a template over Real:
// float, or a batch of floats, one for each of 4, 8 or 16 samples that go through the same formula together.
// Branches become select(mask, a, b). With a batch both sides are computed, so neither may do harm.
#pragma once

#include <cmath>
#include <limits>
#include <xsimd/xsimd.hpp>

// GLM asks for the limits of what it computes with; a batch has those of its lanes. This must stand before GLM.
template<class Arch>
struct std::numeric_limits<xsimd::batch<float, Arch>> : std::numeric_limits<float> {};

namespace core {

// The batch of the instruction set that this file is compiled for.
using Lanes = xsimd::batch<float>;

template<class Real>
struct RealTraits;

template<>
struct RealTraits<float> {
    using Mask = bool;
    static constexpr int lanes = 1;
};

template<class Arch>
struct RealTraits<xsimd::batch<float, Arch>> {
    using Mask = xsimd::batch_bool<float, Arch>;
    static constexpr int lanes = static_cast<int>(xsimd::batch<float, Arch>::size);
};

// The truth of a comparison: bool, or a bool for each lane.
template<class Real>
using Mask = typename RealTraits<Real>::Mask;

inline float select(bool mask, float yes, float no) {
    return mask ? yes : no;
}
inline bool any(bool mask) {
    return mask;
}
inline bool all(bool mask) {
    return mask;
}

template<class Arch>
xsimd::batch<float, Arch> select(xsimd::batch_bool<float, Arch> mask, xsimd::batch<float, Arch> yes,
                                 xsimd::batch<float, Arch> no) {
    return xsimd::select(mask, yes, no);
}
using xsimd::all;
using xsimd::any;

using std::abs;
using std::copysign;
using std::sqrt;
using xsimd::abs;
using xsimd::copysign;
using xsimd::sqrt;

// min and max give b where either is not a number; the order of the words matters for that alone.
template<class Real>
Real min(Real a, Real b) {
    return select(a < b, a, b);
}
template<class Real>
Real max(Real a, Real b) {
    return select(a > b, a, b);
}

// The whole part of x, for 0 <= x < 2^31.
inline float wholePart(float x) {
    return static_cast<float>(static_cast<int>(x));
}
template<class Arch>
xsimd::batch<float, Arch> wholePart(xsimd::batch<float, Arch> x) {
    return xsimd::to_float(xsimd::to_int(x));
}

}  // namespace core
