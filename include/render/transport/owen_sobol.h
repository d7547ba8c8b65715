// The random numbers of a path, spread more evenly than chance would have it: Sobol's points, scrambled in Owen's way.
// Any 2^k samples of a pixel that begin at a multiple of 2^k lie one in each box of a whole family of grids, so that a
// mean over them is nearer to the integral than that over independent numbers.
#pragma once

#include "core/hash.h"
#include "core/lanes.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace render {

// One point of four coordinates, each uniform in [0, 1).
template<class Real>
using Point4 = std::array<Real, 4>;

// The direction numbers of Sobol's first four coordinates (Joe and Kuo, "Constructing Sobol sequences with better
// two-dimensional projections", 2008), their bits in reverse order: [coordinate][bit of the sample's number].
using SobolColumns = std::array<std::array<std::uint32_t, 32>, 4>;

constexpr SobolColumns makeSobolColumns() {
    SobolColumns columns{};
    // degree and coefficients of the primitive polynomials, and the first m of each
    struct Polynomial {
        int degree;
        std::uint32_t coefficients;
        std::array<std::uint32_t, 3> m;
    };
    constexpr std::array<Polynomial, 3> polynomials{{{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}}};
    const auto reversed = [](std::uint32_t x) {
        std::uint32_t r = 0;
        for (int i = 0; i < 32; ++i) r |= (x >> i & 1) << (31 - i);
        return r;
    };
    for (int bit = 0; bit < 32; ++bit) columns[0][static_cast<std::size_t>(bit)] = 1u << bit;
    for (std::size_t d = 1; d < 4; ++d) {
        const Polynomial& p = polynomials[d - 1];
        std::array<std::uint32_t, 32> v{};
        for (int i = 0; i < 32; ++i) {
            const auto at = [&](int k) -> std::uint32_t& { return v[static_cast<std::size_t>(k)]; };
            if (i < p.degree) {
                at(i) = p.m[static_cast<std::size_t>(i)] << (31 - i);
                continue;
            }
            at(i) = at(i - p.degree) ^ (at(i - p.degree) >> p.degree);
            for (int k = 1; k < p.degree; ++k)
                if (p.coefficients >> (p.degree - 1 - k) & 1) at(i) ^= at(i - k);
        }
        for (std::size_t bit = 0; bit < 32; ++bit) columns[d][bit] = reversed(v[bit]);
    }
    return columns;
}

constexpr SobolColumns sobolColumns = makeSobolColumns();

using core::mixed;

// Owen's scrambling of a number whose bits are in reverse order: whether a bit is flipped depends on the seed and on
// the bits below it, which are those that count for more. (Burley, "Practical Hash-based Owen Scrambling", JCGT 2020;
// the constants are Vegdahl's.)
template<class UInt>
UInt owenScrambled(UInt x, UInt seed) {
    x = x ^ (x * UInt(0x3d20adea));
    x = x + seed;
    x = x * ((seed >> 16) | UInt(1));
    x = x ^ (x * UInt(0x05526c56));
    return x ^ (x * UInt(0x53a22864));
}

template<class UInt>
UInt reversedBits(UInt x) {
    x = ((x >> 1) & UInt(0x55555555)) | ((x & UInt(0x55555555)) << 1);
    x = ((x >> 2) & UInt(0x33333333)) | ((x & UInt(0x33333333)) << 2);
    x = ((x >> 4) & UInt(0x0f0f0f0f)) | ((x & UInt(0x0f0f0f0f)) << 4);
    x = ((x >> 8) & UInt(0x00ff00ff)) | ((x & UInt(0x00ff00ff)) << 8);
    return (x >> 16) | (x << 16);
}

// A path's numbers: functions of its pixel, its sample and which four of them are asked for.
template<class Real>
class OwenSobol {
public:
    using UInt = core::UInt<Real>;

    OwenSobol() = default;
    // pixel: of the seed and the pixel, mixed. sample: its number in the pixel, below 2^bits.
    OwenSobol(const UInt& pixel, const UInt& sample, int bits)
        : pixel_(pixel), bits_(bits), reversedSample_(reversedBits(sample)) {
        // A sample's number in [2^k, 2^(k+1)) leaves all bits below k set.
        UInt below = sample >> 1;
        for (int step = 1; step < bits; step *= 2) below = below | (below >> step);
        reversedBelow_ = reversedBits(below);
    }

    // The four of that number, which may differ from lane to lane. Points of different numbers know nothing of each
    // other: their samples come in different orders. The samples of [2^k, 2^(k+1)) change places among themselves, in
    // blocks and blocks of blocks, so that a pixel's first 2^k samples are always the same ones.
    Point4<Real> point(const UInt& number) const {
        const UInt seed = mixed(UInt(pixel_ + number * UInt(0x9e3779b9)));
        const UInt index =
            (owenScrambled(reversedSample_, seed) & reversedBelow_) | (reversedSample_ & ~reversedBelow_);
        std::array<UInt, 4> x{UInt(0), UInt(0), UInt(0), UInt(0)};
        for (int bit = 0; bit < bits_; ++bit) {
            const UInt isSet = UInt(0) - ((index >> (31 - bit)) & UInt(1));
            for (std::size_t d = 0; d < 4; ++d)
                x[d] = x[d] ^ (isSet & UInt(sobolColumns[d][static_cast<std::size_t>(bit)]));
        }
        Point4<Real> point;
        // Seeds that shared but their last bits would turn the first bits of all four together.
        constexpr std::array<std::uint32_t, 4> other{0x85ebca6b, 0xc2b2ae35, 0x27d4eb2f, 0x165667b1};
        for (std::size_t d = 0; d < 4; ++d) {
            const UInt bits = reversedBits(owenScrambled(x[d], mixed(UInt(seed + UInt(other[d])))));
            point[d] = core::toReal(UInt(bits >> 8)) * Real(0x1p-24f);
        }
        return point;
    }

private:
    UInt pixel_ = UInt(0);
    int bits_ = 0;
    UInt reversedSample_ = UInt(0), reversedBelow_ = UInt(0);  // their bits in reverse order
};

}  // namespace render
