#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/frame.h"
#include "core/warp.h"
#include "support/histogram.h"
#include "support/test_random.h"

namespace core {
namespace {

constexpr int samples = 1'000'000;
constexpr double turn = 2 * std::numbers::pi;

// The disc in the square [-1, 1]^2, that as [0, 1]^2. warped: what is made of the first random number.
template<class Function>
support::SquareHistogram discSamples(Function warped) {
    support::SquareHistogram histogram(21, 21);
    support::TestRandom random(20);
    for (int i = 0; i < samples; ++i) {
        const double u = random.next();
        const double v = random.next();
        const Vec2f place = squareToUniformDisc(Vec2f(warped(u), v));
        histogram.add((place.x + 1) / 2, (place.y + 1) / 2);
    }
    return histogram;
}

double discPdf(double x, double y) {
    return 4 * uniformDiscPdfA(Vec2f(2 * x - 1, 2 * y - 1));
}

TEST(SquareToUniformDisc, FollowsItsPdf) {
    const auto result = discSamples([](double u) { return u; }).test(discPdf);
    EXPECT_TRUE(result.accepted) << result.text;
    EXPECT_NEAR(result.integral, 1, 1e-3);
}

// Planted faults: radii that are uniform, areas 2 % (root mean square) off uniform, a pdf 2 % too large.
TEST(SquareToUniformDisc, IsToldFromWrongSamplersAndPdfs) {
    EXPECT_FALSE(discSamples([](double u) { return u * u; }).test(discPdf).accepted);
    const double e = 0.02 * std::numbers::sqrt3;
    EXPECT_FALSE(discSamples([e](double u) { return u + e * u * (1 - u); }).test(discPdf).accepted);
    const auto tooLarge = [](double x, double y) { return 1.02 * discPdf(x, y); };
    EXPECT_FALSE(discSamples([](double u) { return u; }).test(tooLarge).accepted);
}

TEST(SquareToUniformDisc, MapsTheEdgesOfTheSquare) {
    EXPECT_EQ(squareToUniformDisc(Vec2f(0, 0.7f)), Vec2f(0));
    EXPECT_EQ(squareToUniformDisc(Vec2f(1, 0)), Vec2f(1, 0));
    EXPECT_EQ(squareToUniformDisc(Vec2f(1, 0.25f)), Vec2f(0, 1));
    EXPECT_EQ(squareToUniformDisc(Vec2f(0.25f, 0.5f)), Vec2f(-0.5f, 0));
    EXPECT_EQ(uniformDiscPdfA(Vec2f(0.8f, 0.7f)), 0);
}

double heightOf(double degrees) {
    const double sine = std::sin(degrees / 2 * std::numbers::pi / 180);
    return 2 * sine * sine;
}

// Depth in the cone over its height, by turn; depth from the chord, which keeps its digits in narrow cones.
template<class Function>
support::SquareHistogram coneSamples(double height, Function warped) {
    support::SquareHistogram histogram(21, 21);
    support::TestRandom random(21);
    for (int i = 0; i < samples; ++i) {
        const double u = random.next();
        const double v = random.next();
        const glm::dvec3 d(squareToUniformCone(Vec2f(warped(u), v), static_cast<float>(height)));
        const double phi = std::atan2(d.y, d.x) / turn, sine2 = d.x * d.x + d.y * d.y;
        const double depth = d.z > 0.9 ? sine2 / (1 + std::sqrt(1 - sine2)) : 1 - d.z;
        // Rounding at the rim.
        histogram.add(depth > height && depth < height * (1 + 1e-5) ? 1 : depth / height, phi < 0 ? phi + 1 : phi);
    }
    return histogram;
}

auto conePdf(double height) {
    return [height](double depth, double phi) {
        const double z = 1 - depth * height, sine = std::sqrt(depth * height * (1 + z));
        const Vec3f d(sine * std::cos(turn * phi), sine * std::sin(turn * phi), z);
        return uniformConePdfW(Vec3f(0, 0, 1), d, static_cast<float>(height)) * turn * height;
    };
}

TEST(SquareToUniformCone, FollowsItsPdf) {
    for (const double degrees : {1e-3, 0.1, 5.0, 60.0, 90.0, 180.0}) {
        const double height = heightOf(degrees);
        const auto result = coneSamples(height, [](double u) { return u; }).test(conePdf(height));
        EXPECT_TRUE(result.accepted) << degrees << " degrees: " << result.text;
        EXPECT_NEAR(result.integral, 1, 1e-3) << degrees;
    }
}

// Planted faults as above, and a pdf of a cone that is 2 % smaller.
TEST(SquareToUniformCone, IsToldFromWrongSamplersAndPdfs) {
    const double height = heightOf(5), e = 0.02 * std::numbers::sqrt3;
    const auto right = coneSamples(height, [](double u) { return u; });
    EXPECT_FALSE(coneSamples(height, [](double u) { return u * u; }).test(conePdf(height)).accepted);
    EXPECT_FALSE(coneSamples(height, [e](double u) { return u + e * u * (1 - u); }).test(conePdf(height)).accepted);
    EXPECT_FALSE(right.test([&](double x, double y) { return 1.02 * conePdf(height)(x, y); }).accepted);
    const auto smaller = [&](double depth, double phi) {
        return depth < 0.98 ? conePdf(height)(depth, phi) / 0.98 : 0;
    };
    EXPECT_FALSE(right.test(smaller).accepted);
}

TEST(UniformConePdfW, IsZeroOutside) {
    for (const double degrees : {0.1, 5.0, 60.0, 90.0}) {
        const auto height = static_cast<float>(heightOf(degrees));
        const double angle = degrees * std::numbers::pi / 180;
        const auto at = [&](double a) { return Vec3f(0, -std::sin(a), std::cos(a)); };
        EXPECT_NEAR(uniformConePdfW(Vec3f(0, 0, 1), at(0.999 * angle), height) * turn * height, 1, 1e-6) << degrees;
        EXPECT_EQ(uniformConePdfW(Vec3f(0, 0, 1), at(1.001 * angle), height), 0) << degrees;
    }
}

// Turned into any frame, a cone's samples stay where its pdf is.
TEST(UniformConePdfW, HoldsRoundEveryAxis) {
    for (const double degrees : {1e-3, 0.1, 5.0, 90.0}) {
        const auto height = static_cast<float>(heightOf(degrees));
        support::TestRandom random(22);
        int outside = 0;
        for (int i = 0; i < 100'000; ++i) {
            const double u = random.next(), v = random.next(), s = random.next(), t = random.next();
            const Vec3f axis = squareToUniformCone(Vec2f(s, t), 2.f);
            const Vec3f d = Frame<float>(axis).toWorld(squareToUniformCone(Vec2f(u, v), height));
            outside += uniformConePdfW(axis, d, height) == 0;
        }
        EXPECT_LT(outside, 100) << degrees;
    }
}

}  // namespace
}  // namespace core
