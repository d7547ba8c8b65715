// Runs a formula at float and at lanes on the same numbers, and compares the results bit by bit: every operation is
// exactly rounded, and nothing is contracted, so that the widths have no reason to differ.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "core/vec.h"
#include "support/test_random.h"

namespace lanes {

using core::Lanes;

constexpr std::size_t width = core::RealTraits<Lanes>::lanes;

template<std::size_t n>
using Numbers = std::array<float, n>;

// On AVX-512 xsimd negates by 0 - x, which makes no -0: there zeros are the same, whatever their sign. So is all that
// is not a number: which one it is depends on what the compiler calculates itself.
inline bool areSame(float a, float b) {
    constexpr bool zerosAreSame = width == 16;
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (zerosAreSame && a == 0 && b == 0) ||
           (std::isnan(a) && std::isnan(b));
}

template<std::size_t n>
std::string text(const Numbers<n>& numbers) {
    std::ostringstream text;
    for (const float x : numbers) text << " " << x << std::hexfloat << " (" << x << ")" << std::defaultfloat;
    return text.str();
}

template<std::size_t n>
std::array<Lanes, n> lanesOf(const std::array<Numbers<n>, width>& rows) {
    std::array<Lanes, n> columns;
    for (std::size_t k = 0; k < n; ++k) {
        Numbers<width> column;
        for (std::size_t lane = 0; lane < width; ++lane) column[lane] = rows[lane][k];
        columns[k] = Lanes::load_unaligned(column.data());
    }
    return columns;
}

template<std::size_t m>
std::array<Numbers<m>, width> rowsOf(const std::array<Lanes, m>& columns) {
    std::array<Numbers<m>, width> rows;
    for (std::size_t k = 0; k < m; ++k) {
        Numbers<width> column;
        columns[k].store_unaligned(column.data());
        for (std::size_t lane = 0; lane < width; ++lane) rows[lane][k] = column[lane];
    }
    return rows;
}

// formula: from std::array<Real, n> to std::array<Real, m>, for both Reals. Gives the results at float, for the caller
// to see that the inputs were not all of one kind.
template<std::size_t n, class Formula>
auto expectSame(const std::vector<Numbers<n>>& inputs, const Formula& formula) {
    std::vector<decltype(formula(inputs[0]))> results;
    int differences = 0;
    for (std::size_t first = 0; first < inputs.size(); first += width) {
        // The last lanes begin again with the first inputs.
        std::array<Numbers<n>, width> rows;
        for (std::size_t lane = 0; lane < width; ++lane) rows[lane] = inputs[(first + lane) % inputs.size()];
        const auto wide = rowsOf(formula(lanesOf(rows)));
        for (std::size_t lane = 0; lane < width; ++lane) {
            const auto narrow = formula(rows[lane]);
            if (first + lane < inputs.size()) results.push_back(narrow);
            for (std::size_t k = 0; k < wide[lane].size(); ++k) {
                if (areSame(wide[lane][k], narrow[k]) || ++differences > 3) continue;
                ADD_FAILURE() << "result " << k << " of" << text(rows[lane]) << " is" << text(narrow) << " at float and"
                              << text(wide[lane]) << " in lane " << lane << " of " << width;
            }
        }
    }
    EXPECT_EQ(differences, 0) << "of " << inputs.size() << " inputs";
    return results;
}

// A mask as a number.
template<class Real>
Real asNumber(const core::Mask<Real>& mask) {
    return core::select(mask, Real(1), Real(0));
}

template<class Real>
core::Vec3<Real> vectorAt(const Real* numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

// Numbers of every size and sign, and often those at which formulas turn: 0, -0, 1, halves, powers, infinity.
class Inputs {
public:
    explicit Inputs(std::uint64_t seed) : random_(seed) {}

    float uniform(float least, float most) { return least + (most - least) * static_cast<float>(random_.next()); }
    bool chance(double probability) { return random_.next() < probability; }
    template<std::size_t n>
    float oneOf(const float (&choices)[n]) {
        return choices[random_.nextBits() % n];
    }

    float any() {
        if (chance(0.5)) return uniform(-2, 2);
        if (chance(0.5)) return oneOf({0, -0.f, 1, -1, 0.5f, -0.5f, 2, -2});
        return oneOf({0x1p-149f, -0x1p-126f, 1e-20f, -1e-6f, 1 + 0x1p-23f, 1 - 0x1p-24f, 1e4f, -1e20f, 3e38f,
                      core::infinity, -core::infinity});
    }

    // In [0, 1), as random numbers are, and 1.
    float unit() {
        if (chance(0.8)) return static_cast<float>(random_.nextBits() >> 40) * 0x1p-24f;
        return oneOf({0, 0x1p-24f, 0.125f, 0.25f, 0.375f, 0.5f, 0.625f, 0.75f, 0.875f, 1 - 0x1p-24f, 1});
    }

    // In a cube round the origin.
    core::Vec3f point(float size) {
        const float x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
        return {x, y, z};
    }

    // A vector of unit length, often along an axis or in a plane of two.
    core::Vec3f direction() {
        for (;;) {
            core::Vec3f v;
            for (int axis = 0; axis < 3; ++axis) v[axis] = chance(0.2) ? oneOf({0, -0.f}) : uniform(-1, 1);
            const float length = glm::length(v);
            if (length > 1e-3f) return v / length;
        }
    }

private:
    support::TestRandom random_;
};

template<std::size_t n, class Make>
std::vector<Numbers<n>> makeInputs(int count, const Make& make) {
    std::vector<Numbers<n>> inputs;
    for (int i = 0; i < count; ++i) inputs.push_back(make());
    return inputs;
}

}  // namespace lanes
