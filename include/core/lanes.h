// Real numbers, one or many at a time. Everything that computes light is a template over Real:
// float, or a batch of floats, one for each of 4, 8 or 16 samples that go through the same formula together.
// Branches become select(mask, a, b). With a batch both sides are computed, so neither may do harm.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
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
    using UInt = std::uint32_t;
    static constexpr int lanes = 1;
};

// For what is done once, to all digits.
template<>
struct RealTraits<double> {
    using Mask = bool;
    static constexpr int lanes = 1;
};

template<class Arch>
struct RealTraits<xsimd::batch<float, Arch>> {
    using Mask = xsimd::batch_bool<float, Arch>;
    using UInt = xsimd::batch<std::uint32_t, Arch>;
    static constexpr int lanes = static_cast<int>(xsimd::batch<float, Arch>::size);
};

// The truth of a comparison: bool, or a bool for each lane.
template<class Real>
using Mask = typename RealTraits<Real>::Mask;

// A whole number of 32 bits, or one for each lane.
template<class Real>
using UInt = typename RealTraits<Real>::UInt;

template<class Real>
inline constexpr int laneCount = RealTraits<Real>::lanes;

inline float select(bool mask, float yes, float no) {
    return mask ? yes : no;
}
inline double select(bool mask, double yes, double no) {
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
using std::sqrt;
using xsimd::abs;
using xsimd::sqrt;

// Where just one of the two is true. (Not a != b: on SSE xsimd compares masks as numbers, and true is not a number.)
inline bool differ(bool a, bool b) {
    return a != b;
}
template<class Arch>
xsimd::batch_bool<float, Arch> differ(const xsimd::batch_bool<float, Arch>& a,
                                      const xsimd::batch_bool<float, Arch>& b) {
    return (a & !b) | (b & !a);
}

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

// Whole numbers that stand in a row.
template<class Real>
UInt<Real> loadUInt(const std::uint32_t* row) {
    if constexpr (laneCount<Real> == 1)
        return *row;
    else
        return UInt<Real>::load_unaligned(row);
}

template<class Real>
void storeUInt(const UInt<Real>& numbers, std::uint32_t* row) {
    if constexpr (laneCount<Real> == 1)
        *row = numbers;
    else
        numbers.store_unaligned(row);
}

// Whole numbers below 2^24 as Reals, and back.
inline float toReal(std::uint32_t i) {
    return static_cast<float>(i);
}
template<class Arch>
xsimd::batch<float, Arch> toReal(const xsimd::batch<std::uint32_t, Arch>& i) {
    return xsimd::to_float(xsimd::bitwise_cast<xsimd::batch<std::int32_t, Arch>>(i));
}
inline std::uint32_t toUInt(float x) {
    return static_cast<std::uint32_t>(x);
}
template<class Arch>
xsimd::batch<std::uint32_t, Arch> toUInt(const xsimd::batch<float, Arch>& x) {
    return xsimd::bitwise_cast<xsimd::batch<std::uint32_t, Arch>>(xsimd::to_int(x));
}

// The same bits as a number of the other kind: whole numbers go through select and gather as Reals, which never looks
// at what they are.
inline float bitsAsReal(std::uint32_t i) {
    return std::bit_cast<float>(i);
}
inline std::uint32_t bitsAsUInt(float x) {
    return std::bit_cast<std::uint32_t>(x);
}
template<class Arch>
xsimd::batch<float, Arch> bitsAsReal(const xsimd::batch<std::uint32_t, Arch>& i) {
    return xsimd::bitwise_cast<xsimd::batch<float, Arch>>(i);
}
template<class Arch>
xsimd::batch<std::uint32_t, Arch> bitsAsUInt(const xsimd::batch<float, Arch>& x) {
    return xsimd::bitwise_cast<xsimd::batch<std::uint32_t, Arch>>(x);
}
// Comparisons of whole numbers.
inline bool isLess(std::uint32_t a, std::uint32_t b) {
    return a < b;
}
template<class Arch>
xsimd::batch_bool<float, Arch> isLess(const xsimd::batch<std::uint32_t, Arch>& a,
                                      const xsimd::batch<std::uint32_t, Arch>& b) {
    using UInt = xsimd::batch<std::uint32_t, Arch>;
    const UInt one(std::bit_cast<std::uint32_t>(1.f));
    return bitsAsReal(UInt(xsimd::select(a < b, one, UInt(0)))) != xsimd::batch<float, Arch>(0.f);
}
template<class Real>
UInt<Real> selectUInt(const Mask<Real>& mask, const UInt<Real>& yes, const UInt<Real>& no) {
    return bitsAsUInt(select(mask, bitsAsReal(yes), bitsAsReal(no)));
}

// The lower 16 bits as a whole number with a sign.
inline float signedHalf(std::uint32_t i) {
    return static_cast<float>(static_cast<std::int16_t>(i & 0xffff));
}
template<class Arch>
xsimd::batch<float, Arch> signedHalf(const xsimd::batch<std::uint32_t, Arch>& i) {
    using Int = xsimd::batch<std::int32_t, Arch>;
    return xsimd::to_float((xsimd::bitwise_cast<Int>(i) << 16) >> 16);
}

// table[index], for each lane. Every lane's index must be within the table, whether it counts or not.
inline float gather(const float* table, std::uint32_t index) {
    return table[index];
}
template<class Arch>
xsimd::batch<float, Arch> gather(const float* table, const xsimd::batch<std::uint32_t, Arch>& index) {
    // xsimd leaves the processor's own instructions unused where it may multiply and add in one.
#ifdef __AVX512F__
    if constexpr (xsimd::batch<float, Arch>::size == 16) return _mm512_i32gather_ps(index.data, table, sizeof(float));
#endif
#ifdef __AVX2__
    if constexpr (xsimd::batch<float, Arch>::size == 8) return _mm256_i32gather_ps(table, index.data, sizeof(float));
#endif
    return xsimd::batch<float, Arch>::gather(table, xsimd::bitwise_cast<xsimd::batch<std::int32_t, Arch>>(index));
}

// A bit for each lane, the first one's last.
inline std::uint32_t bitsOf(bool mask) {
    return mask ? 1 : 0;
}
template<class Arch>
std::uint32_t bitsOf(const xsimd::batch_bool<float, Arch>& mask) {
    constexpr int lanes = xsimd::batch<float, Arch>::size;
#ifdef __AVX512F__
    if constexpr (lanes == 16) return mask.data;
#endif
#ifdef __AVX__
    if constexpr (lanes == 8) return static_cast<std::uint32_t>(_mm256_movemask_ps(mask.data));
#endif
#ifdef __SSE__
    if constexpr (lanes == 4) return static_cast<std::uint32_t>(_mm_movemask_ps(mask.data));
#endif
    bool one[lanes];
    mask.store_unaligned(one);
    std::uint32_t bits = 0;
    for (int lane = 0; lane < lanes; ++lane) bits |= std::uint32_t{one[lane]} << lane;
    return bits;
}
template<class Mask>
int countOf(const Mask& mask) {
    return std::popcount(bitsOf(mask));
}

// Calls f(lane) for each lane of a mask.
template<class F>
void forEachLane(std::uint32_t bits, F&& f) {
    for (; bits != 0; bits &= bits - 1) f(std::countr_zero(bits));
}

// The numbers of all lanes in a row, to be read and written one by one.
template<class Real>
struct LaneArray {
    alignas(64) float lane[laneCount<Real>];

    LaneArray() = default;
    explicit LaneArray(const Real& x) {
        if constexpr (laneCount<Real> == 1)
            lane[0] = x;
        else
            x.store_aligned(lane);
    }
    Real real() const {
        if constexpr (laneCount<Real> == 1)
            return lane[0];
        else
            return Real::load_aligned(lane);
    }
    float& operator[](int i) { return lane[i]; }
    float operator[](int i) const { return lane[i]; }
};

// The lanes of which a bit is set.
template<class Real>
Mask<Real> maskOf(std::uint32_t bits) {
    LaneArray<Real> set;
    for (int i = 0; i < laneCount<Real>; ++i) set[i] = bits >> i & 1 ? 1.f : 0.f;
    return set.real() != Real(0);
}

}  // namespace core
