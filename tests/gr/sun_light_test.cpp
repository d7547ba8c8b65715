// Suns and spots against closed forms.
// Seen to fail with the radiance of the half angle taken for the whole one, with a disc that is uniform in its radius,
// light that goes the other way, the cone's whole angle taken for the half one, and fading that goes straight.
#include "gr/light.h"
#include "support/histogram.h"
#include "support/test_random.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::Rgbf;
using core::Vec2f;
using core::Vec3f;

TEST(SunLight, IrradianceIsPiTimesItsColour) {
    const glm::dvec3 along(2, -3, 6);
    const Rgbf colour(3, 0.5f, 0);
    for (const double degrees : {1e-4, 0.53, 10., 90., 180.}) {
        const SunLight sun = SunLight::make(along, colour, degrees);
        const Vec3f normal(-glm::normalize(along));
        // A rule over the square that is exact but for the azimuth, which does not matter.
        glm::dvec3 sum(0);
        constexpr int steps = 1000;
        for (int i = 0; i < steps; ++i) {
            const auto sample =
                sun.sample(Vec3f(0), Vec2f((i + 0.5f) / steps, 0.618034f * static_cast<float>(i % 97) / 97));
            sum += glm::dvec3(sample.weight) * double{glm::dot(sample.wi, normal)} / double{steps};
            const auto seen = sun.seen(sample.wi);
            ASSERT_FLOAT_EQ(seen.pdfW, sample.pdfW) << degrees;
            ASSERT_FLOAT_EQ(seen.radiance.x, sample.weight.x * sample.pdfW) << degrees;
        }
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], M_PI * colour[c], 2e-5 * M_PI * colour[c]) << degrees;
    }
}

TEST(SunLight, IsUniformOverItsDisc) {
    const SunLight sun = SunLight::make({1, 0, -0.5}, Rgbf(1), 70);
    support::TestRandom random(5);
    support::SphereHistogram histogram;
    for (int i = 0; i < 1'000'000; ++i) {
        const Vec3f wi = sun.sample(Vec3f(0), Vec2f(random.next(), random.next())).wi;
        histogram.add(wi.x, wi.y, wi.z);
    }
    const auto result =
        histogram.test([&](double x, double y, double z) { return double{sun.seen(Vec3f(glm::dvec3(x, y, z))).pdfW}; });
    EXPECT_TRUE(result.accepted) << result.text;
}

// As far from its middle as half of the angle, and no farther.
TEST(SunLight, HasASharpEdge) {
    const SunLight sun = SunLight::make({0, -1, 0}, Rgbf(1), 0.53);
    for (const double degrees : {0., 0.2, 0.26, 0.27, 1., 90., 180.}) {
        const double a = degrees * M_PI / 180;
        const auto seen = sun.seen(Vec3f(glm::dvec3(std::sin(a), std::cos(a), 0)));
        EXPECT_EQ(seen.radiance.x > 0, degrees < 0.265) << degrees;
        EXPECT_EQ(seen.pdfW > 0, degrees < 0.265) << degrees;
    }
}

TEST(ParallelLight, ComesFromOneDirection) {
    const ParallelLight sun = ParallelLight::make({0, -1e30, 0}, {1, 2, 3});
    const auto sample = sun.sample(Vec3f(4, 5, 6));
    EXPECT_EQ(sample.wi, Vec3f(0, 1, 0));
    EXPECT_EQ(sample.weight, Rgbf(1, 2, 3) * core::pi);
    EXPECT_EQ(sample.pdfW, 0);
}

// Against the formula in double precision, from every side, near and far.
TEST(SpotLight, FadesAsBlendersDoes) {
    const PointLight point{{1, 2, 3}, {3, 0.5f, 0}, {0.2f, 0.1f, 1}};
    const glm::dvec3 along(0.2, -1, 0.4);
    support::TestRandom random(6);
    for (const double degrees : {0.2, 30., 120., 180.}) {
        for (const double softness : {0., 0.15, 1.}) {
            const SpotLight spot = SpotLight::make(point, along, degrees, softness);
            int lit = 0;
            for (int i = 0; i < 2000; ++i) {
                const core::Frame<double> frame(glm::normalize(along));
                const double angle = 0.6 * random.next() * degrees * M_PI / 180, turn = 2 * M_PI * random.next();
                const glm::dvec3 way = frame.toWorld(
                    {std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle)});
                const Vec3f from = point.position + Vec3f(way * (0.5 + 5 * random.next()));
                const double c = std::cos(angle), edge = std::cos(degrees * M_PI / 360);
                if (std::abs(angle - degrees * M_PI / 360) < 1e-3 * degrees * M_PI / 180) continue;
                const double t =
                    softness == 0 ? (c > edge ? 1 : 0) : std::clamp((c - edge) / (softness * (1 - edge)), 0., 1.);
                const double expected = point.sample(from).weight.x * t * t * (3 - 2 * t);
                ASSERT_NEAR(spot.sample(from).weight.x, expected, 3e-3 * point.sample(from).weight.x)
                    << degrees << " " << softness;
                lit += expected > 0 ? 1 : 0;
            }
            EXPECT_GT(lit, 1000);
            EXPECT_LT(lit, 1990);
        }
    }
}

TEST(SpotLight, IsAPointLightAlongItsAxis) {
    const PointLight point{{1, 2, 3}, {3, 0.5f, 0}, {0.2f, 0.1f, 1}};
    const SpotLight spot = SpotLight::make(point, {0, -2, 0}, 45, 0.15);
    const auto a = spot.sample(Vec3f(1, -1, 3)), b = point.sample(Vec3f(1, -1, 3));
    EXPECT_EQ(a.weight, b.weight);
    EXPECT_EQ(a.wi, b.wi);
    EXPECT_EQ(spot.sample(Vec3f(1, 5, 3)).weight, Rgbf(0)) << "behind it";
    EXPECT_EQ(spot.sample(point.position).weight, Rgbf(0)) << "at its own place";
}

}  // namespace
}  // namespace gr
