#include "core/warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/histogram.h"
#include "support/test_random.h"

namespace core {
namespace {

constexpr int samples = 1'000'000;

// All the numbers that toUnitInterval gives, and 1. The bound is what rounding makes of the angle, which is at most
// pi/4 from the nearest quarter (2 pi in float, and the product: 5e-8 together), and of the result (3e-8), and of
// the last sum of the series (1e-8).
TEST(SinCosTurns, IsTheSineAndCosine) {
    double worst = 0;
    for (int i = 0; i <= 1 << 24; ++i) {
        const float turns = static_cast<float>(i) * 0x1p-24f;
        const SinCos<float> result = sinCosTurns(turns);
        const double angle = 2 * std::numbers::pi * turns;
        worst = std::max({worst, std::abs(result.sin - std::sin(angle)), std::abs(result.cos - std::cos(angle))});
    }
    EXPECT_LT(worst, 1e-7);
}

TEST(SinCosTurns, IsExactAtTheQuarters) {
    const float sines[] = {0, 1, 0, -1, 0};
    const float cosines[] = {1, 0, -1, 0, 1};
    for (int quarter = 0; quarter <= 4; ++quarter) {
        const SinCos<float> result = sinCosTurns(static_cast<float>(quarter) / 4);
        EXPECT_EQ(result.sin, sines[quarter]) << quarter;
        EXPECT_EQ(result.cos, cosines[quarter]) << quarter;
    }
}

// Directions that squareToUniformHemisphere makes of points (warped(u), v), u and v uniform.
template<class Function>
support::SphereHistogram hemisphereSamples(Function warped) {
    support::SphereHistogram histogram;
    support::TestRandom random(1);
    for (int i = 0; i < samples; ++i) {
        const double u = random.next();
        const double v = random.next();
        const Vec3f d = squareToUniformHemisphere(Vec2f(warped(u), v));
        histogram.add(d.x, d.y, d.z);
    }
    return histogram;
}

double pdfW(double x, double y, double z) {
    return uniformHemispherePdfW(Vec3f(x, y, z));
}

TEST(SquareToUniformHemisphere, FollowsItsPdf) {
    const auto result = hemisphereSamples([](double u) { return u; }).test(pdfW);
    EXPECT_TRUE(result.accepted) << result.text;
    EXPECT_NEAR(result.integral, 1, 1e-3);
}

// Planted faults: heights drawn as cosines are, heights 2 % (root mean square) off uniform, the pdf of the cosine, and
// a pdf 2 % too large. All are rejected.
TEST(SquareToUniformHemisphere, IsToldFromWrongSamplersAndPdfs) {
    EXPECT_FALSE(hemisphereSamples([](double u) { return std::sqrt(u); }).test(pdfW).accepted);
    // The height's density is 1 / (1 + e (1 - 2 u)), to first order 1 + e (2 u - 1).
    const double e = 0.02 * std::numbers::sqrt3;
    EXPECT_FALSE(hemisphereSamples([e](double u) { return u + e * u * (1 - u); }).test(pdfW).accepted);

    const auto right = hemisphereSamples([](double u) { return u; });
    const auto cosine = [](double, double, double z) { return std::max(0.0, z) / std::numbers::pi; };
    EXPECT_FALSE(right.test(cosine).accepted);
    const auto tooLarge = [](double x, double y, double z) { return 1.02 * pdfW(x, y, z); };
    EXPECT_FALSE(right.test(tooLarge).accepted);
}

support::SphereHistogram cosineSamples(const Vec3f& scale) {
    support::SphereHistogram histogram;
    support::TestRandom random(1);
    for (int i = 0; i < samples; ++i) {
        const double u = random.next();
        const double v = random.next();
        const Vec3f d = glm::normalize(squareToCosineHemisphere(Vec2f(u, v)) * scale);
        histogram.add(d.x, d.y, d.z);
    }
    return histogram;
}

// Planted faults: directions a hair too steep, the uniform density, and a density 2 % too large. All are rejected.
TEST(SquareToCosineHemisphere, FollowsItsPdf) {
    const auto pdf = [](double x, double y, double z) { return cosineHemispherePdfW(Vec3f(x, y, z)); };
    const auto right = cosineSamples(Vec3f(1));
    const auto result = right.test(pdf);
    EXPECT_TRUE(result.accepted) << result.text;
    EXPECT_NEAR(result.integral, 1, 1e-3);
    EXPECT_FALSE(cosineSamples({1, 1, 1.02f}).test(pdf).accepted);
    EXPECT_FALSE(right.test(pdfW).accepted);
    EXPECT_FALSE(right.test([&](double x, double y, double z) { return 1.02 * pdf(x, y, z); }).accepted);
}

TEST(SquareToUniformHemisphere, MapsTheEdgesOfTheSquare) {
    EXPECT_EQ(squareToUniformHemisphere(Vec2f(1, 0.3f)), Vec3f(0, 0, 1));
    EXPECT_EQ(squareToUniformHemisphere(Vec2f(0, 0)), Vec3f(1, 0, 0));
    EXPECT_EQ(squareToUniformHemisphere(Vec2f(0, 0.25f)), Vec3f(0, 1, 0));
    EXPECT_EQ(squareToUniformHemisphere(Vec2f(0, 1)), squareToUniformHemisphere(Vec2f(0, 0)));
}

TEST(SquareToUniformHemisphere, GivesUnitVectors) {
    for (int i = 0; i <= 1000; ++i) {
        for (int j = 0; j <= 100; ++j) {
            const Vec3f d = squareToUniformHemisphere(Vec2f(i / 1000.f, j / 100.f));
            ASSERT_NEAR(glm::length(glm::dvec3(d)), 1, 3e-7) << i << " " << j;
        }
    }
}

TEST(UniformHemispherePdfW, IsZeroBelowTheHorizon) {
    EXPECT_EQ(uniformHemispherePdfW(Vec3f(0, 0, 1)), 1 / (2 * pi));
    EXPECT_EQ(uniformHemispherePdfW(Vec3f(1, 0, 0)), 1 / (2 * pi));
    EXPECT_EQ(uniformHemispherePdfW(Vec3f(1, 0, -1e-30f)), 0);
    EXPECT_EQ(uniformHemispherePdfW(Vec3f(0, 0, -1)), 0);
}

// A disc of radius r seen from distance h above its centre fills the solid angle 2 pi (1 - h / sqrt(h^2 + r^2)): over
// it, the uniform density by area, taken by solid angle, must integrate to 1.
TEST(PdfAtoW, TurnsADensityOverADiscIntoOneOverDirections) {
    const double h = 0.7, r = 1.3;
    const double cosineAtTheRim = h / std::hypot(h, r);
    const auto density = [&](double cosine) {
        const double distance = h / cosine;
        return 2 * std::numbers::pi * pdfAtoW(1 / (std::numbers::pi * r * r), distance * distance, cosine);
    };
    EXPECT_NEAR(support::integrate(density, cosineAtTheRim, 1, 1e-9), 1, 1e-8);
}

}  // namespace
}  // namespace core
