#include "core/elementary.h"
#include "core/vec.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace core {
namespace {

// Two units in the last place, where they are largest.
constexpr double bound = 2 * 0x1p-23;

double relativeError(float value, double expected) {
    return std::abs(value - expected) / std::abs(expected);
}

float fromBits(std::int32_t bits) {
    return std::bit_cast<float>(bits);
}

TEST(Log, IsTheLogarithm) {
    double worst = 0;
    // Some of all normal numbers; 1 is among them.
    for (std::int64_t bits = 0x00800000; bits <= 0x7f7fffff; bits += 211) {
        const float x = fromBits(static_cast<std::int32_t>(bits));
        if (x != 1) worst = std::max(worst, relativeError(log(x), std::log(static_cast<double>(x))));
    }
    EXPECT_LT(worst, bound);
}

// To all its digits, however small it is; and from either side.
TEST(Log, IsTheLogarithmNear1) {
    double worst = 0;
    const std::int32_t one = std::bit_cast<std::int32_t>(1.f);
    for (std::int32_t bits = one - 200'000; bits <= one + 200'000; ++bits)
        if (bits != one)
            worst = std::max(worst, relativeError(log(fromBits(bits)), std::log(static_cast<double>(fromBits(bits)))));
    EXPECT_LT(worst, bound);
    EXPECT_EQ(log(1.f), 0);
}

TEST(Log, HoldsAtTheEndsOfItsRange) {
    EXPECT_FLOAT_EQ(log(std::numeric_limits<float>::min()), -87.336544f);
    EXPECT_FLOAT_EQ(log(std::numeric_limits<float>::max()), 88.722839f);
}

// The larger of neighbouring floats never has a logarithm that is smaller by more than rounding is; where the mantissa
// turns from sqrt(2) to sqrt(1/2) above all.
TEST(Log, HasNoStepWhereTheMantissaTurns) {
    for (int exponent = -125; exponent <= 127; ++exponent) {
        const std::int32_t turn = bitsOfHalfsRoot + exponent * (1 << 23);
        float last = log(fromBits(turn - 1000));
        for (std::int32_t bits = turn - 999; bits <= turn + 1000; ++bits) {
            const float next = log(fromBits(bits));
            ASSERT_GE(next, last - std::abs(last) * 0x1p-23f) << exponent << " " << bits - turn;
            last = std::max(next, last);
        }
    }
}

constexpr double ln2 = 0.69314718055994530942;

TEST(Exp, IsTheExponential) {
    double worst = 0;
    for (int i = 0; i <= 4'000'000; ++i) {
        const float x = -87 + 175 * (static_cast<float>(i) / 4e6f);
        worst = std::max(worst, relativeError(exp(x), std::exp(static_cast<double>(x))));
    }
    EXPECT_LT(worst, bound);
    EXPECT_EQ(exp(0.f), 1);
}

TEST(Exp, IsZeroBelowItsRange) {
    EXPECT_GT(exp(-87.f), 0);
    for (const float x : {-87.00001f, -88.f, -1e10f, -infinity}) EXPECT_EQ(exp(x), 0) << x;
    EXPECT_LT(relativeError(exp(88.f), std::exp(88.0)), bound);
}

// Where the whole part of x / ln 2 turns to the next.
TEST(Exp, HasNoStepWhereTheScaleTurns) {
    for (int n = -125; n <= 126; ++n) {
        float x = static_cast<float>((n + 0.5) * ln2 - 1e-5 * (std::abs(n) + 1)), last = exp(x), lastMinus1 = expm1(x);
        for (int i = 0; i < 1000; ++i) {
            x = std::nextafter(x, infinity);
            const float next = exp(x), nextMinus1 = expm1(x);
            ASSERT_GE(next, last * (1 - 0x1p-23f)) << x;
            ASSERT_GE(nextMinus1, lastMinus1 - std::abs(lastMinus1) * 0x1p-23f) << x;
            last = std::max(last, next);
            lastMinus1 = std::max(lastMinus1, nextMinus1);
        }
    }
}

TEST(Expm1, IsTheExponentialMinus1) {
    double worst = 0;
    for (int i = 0; i <= 4'000'000; ++i) {
        const float x = -87 + 175 * (static_cast<float>(i) / 4e6f);
        if (x != 0) worst = std::max(worst, relativeError(expm1(x), std::expm1(static_cast<double>(x))));
    }
    EXPECT_LT(worst, bound);
    EXPECT_EQ(expm1(-1000.f), -1);
}

// To all its digits, however near.
TEST(Expm1, IsTheExponentialMinus1Near0) {
    double worst = 0;
    for (std::int32_t bits = 0x00800000; bits < std::bit_cast<std::int32_t>(1.f); bits += 501)
        for (const float x : {fromBits(bits), -fromBits(bits)})
            worst = std::max(worst, relativeError(expm1(x), std::expm1(static_cast<double>(x))));
    EXPECT_LT(worst, bound);
    EXPECT_EQ(expm1(0.f), 0);
}

// Planted faults: ln 2 in one part, and a series two terms too short. Both are beyond the bound.
TEST(Elementary, BoundTellsFaults) {
    const float x = 80.3f, n = 116, rest = x - n * 0.6931472f;
    const float onePart = powerOfTwo(n) * static_cast<float>(std::exp(static_cast<double>(rest)));
    EXPECT_GT(relativeError(onePart, std::exp(static_cast<double>(x))), bound);
    const float m = 1.41f, s = (m - 1) / (m + 1), s2 = s * s;
    const float tooShort = 2 * (s + s * s2 * (1 / 3.f + s2 * (1 / 5.f)));
    EXPECT_GT(relativeError(tooShort, std::log(static_cast<double>(m))), bound);
}

// All round, and at every ratio of height and width.
TEST(Atan2, IsTheAngleOfADirection) {
    double worst = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const double turn = 2 * M_PI * (i / 1e6 - 0.5), size = std::exp2(i % 41 - 20);
        const auto x = static_cast<float>(size * std::cos(turn)), y = static_cast<float>(size * std::sin(turn));
        worst =
            std::max(worst, std::abs(atan2<float>(y, x) - std::atan2(static_cast<double>(y), static_cast<double>(x))));
    }
    EXPECT_LT(worst, 0x1p-21);
    for (float ratio = 1e-30f; ratio < 1e30f; ratio *= 1.01f) {
        const double expected = std::atan(static_cast<double>(ratio));
        ASSERT_LT(relativeError(atan2<float>(ratio, 1), expected), 4 * 0x1p-23) << ratio;
        ASSERT_LT(relativeError(atan2<float>(1, ratio), std::atan2(1., static_cast<double>(ratio))), 4 * 0x1p-23)
            << ratio;
    }
}

TEST(Atan2, HoldsAlongTheAxes) {
    EXPECT_EQ(atan2<float>(0, 0), 0);
    EXPECT_EQ(atan2<float>(0, 2), 0);
    EXPECT_FLOAT_EQ(atan2<float>(3, 0), pi / 2);
    EXPECT_FLOAT_EQ(atan2<float>(-3, 0), -pi / 2);
    EXPECT_FLOAT_EQ(atan2<float>(0, -1), pi);
    EXPECT_FLOAT_EQ(atan2<float>(-1, -1), -0.75f * pi);
}

}  // namespace
}  // namespace core
