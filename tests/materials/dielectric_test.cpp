// planted_dielectric_fault_test.cpp sees firstInterfaceFault fail.
#include "materials/dielectric.h"

#include <gtest/gtest.h>

#include "materials/dielectric_checks.h"
#include "support/statistics.h"

namespace materials {
namespace {

using core::Rgbf;
using core::Vec3f;

constexpr core::Weights reflection{0, 1, 0, 0}, refraction{0, 0, 1, 0};

TEST(Dielectric, ReflectsAndRefractsAsTheTextbookSays) {
    EXPECT_EQ(firstInterfaceFault(Dielectric{}), "");
}

TEST(Dielectric, ReflectsAlongTheNormalByTheIndexAlone) {
    for (const float n : {1.5f, 1 / 1.5f, 1.f, 1.33f, 1e3f, 1e-3f, 1e6f, 1e-6f}) {
        const double root = (n - 1.0) / (n + 1.0);
        const auto sample = sampleBy(Dielectric{}, reflection, Vec3f(0, 0, 1), n);
        EXPECT_TRUE(sample.valid);
        EXPECT_NEAR(sample.weight.x, root * root, 1e-6) << n;
        EXPECT_EQ(sample.weight, Rgbf(sample.weight.x));
    }
}

// A surface between equal media: all goes straight on, from any direction.
TEST(Dielectric, IsNotThereWhereTheIndicesAreEqual) {
    for (const double angle : {0.0, 0.5, 1.0, 1.5, 1.57, 1.5707}) {
        const Vec3f wo = directionAt(angle);
        const auto sample = sampleBy(Dielectric{}, refraction, wo, 1);
        EXPECT_TRUE(sample.valid);
        EXPECT_NEAR(sample.weight.x, 1, 1e-6) << angle;
        EXPECT_LT(glm::length(sample.wi + wo), 1e-6) << angle;
    }
}

TEST(Dielectric, ReflectsTotallyBeyondTheCriticalAngle) {
    const float n = 1 / 1.5f;
    const double critical = std::asin(n);
    for (const double beyond : {1e-6, 1e-3, 0.1, 0.5}) {
        const Vec3f wo = directionAt(critical + beyond), within = directionAt(critical - beyond);
        EXPECT_FALSE(sampleBy(Dielectric{}, refraction, wo, n).valid) << beyond;
        EXPECT_TRUE(sampleBy(Dielectric{}, refraction, within, n).valid) << beyond;
        EXPECT_EQ(sampleBy(Dielectric{}, reflection, wo, n).weight, Rgbf(1)) << beyond;
        // Without `sampling`, no draw is lost.
        for (const float u : {0.f, 0.5f, 1 - 0x1p-24f}) {
            const auto sample = bsdfOf(Dielectric{}).sample(wo, BsdfDraw<float>{u, {0.5f, 0.5f}}, n);
            EXPECT_TRUE(sample.valid && sample.wi.z > 0 && sample.weight == Rgbf(1)) << beyond;
        }
    }
    // Exactly there.
    const Vec3f wo(0.5f, 0, std::sqrt(0.75f));
    EXPECT_FALSE(sampleBy(Dielectric{}, refraction, wo, 0.5f).valid);
    EXPECT_EQ(sampleBy(Dielectric{}, reflection, wo, 0.5f).weight, Rgbf(1));
}

// Seen to fail with the reflectance of the other side of the surface.
TEST(Dielectric, ReflectsAsOftenAsItReflectsMuch) {
    for (const float n : {1.5f, 1 / 1.5f})
        for (const double angle : {0.0, 0.6, 0.7}) {
            const Vec3f wo = directionAt(angle);
            support::RunningMean reflections;
            support::TestRandom random(9);
            for (int i = 0; i < 250'000; ++i) {
                const auto sample = bsdfOf(Dielectric{}).sample(wo, nextDraw(random), n);
                const bool reflects = sample.wi.z > 0;
                ASSERT_TRUE(sample.valid);
                ASSERT_FLOAT_EQ(sample.weight.x, reflects ? 1 : 1 / (n * n));
                reflections.add(reflects ? 1 : 0);
            }
            const auto result = support::zTest(reflections, textbookReflectance(angle, n));
            EXPECT_TRUE(result.accepted) << "n " << n << ", angle " << angle << ": " << result.text;
        }
}

// The weight times the method's probability is what goes that way, however often it is drawn.
TEST(Dielectric, WeighsByTheProbabilityOfTheMethod) {
    const Dielectric glass{.sampling = core::Weights{0, 0.25f, 0.75f, 0}};
    for (const float n : {1.5f, 1 / 1.5f}) {
        const double angle = 0.6, reflectance = textbookReflectance(angle, n);
        const auto sample = [&](float u) {
            return bsdfOf(glass).sample(directionAt(angle), BsdfDraw<float>{u, {0.5f, 0.5f}}, n);
        };
        EXPECT_NEAR(sample(0.249f).weight.x * 0.25, reflectance, 1e-5);
        EXPECT_NEAR(sample(0.251f).weight.x * 0.75, (1 - reflectance) / (n * n), 1e-5);
        EXPECT_GT(sample(0.249f).wi.z, 0);
        EXPECT_LT(sample(0.251f).wi.z, 0);
    }
}

TEST(Dielectric, GivesNoSampleWhereItIsToDoWhatItCannot) {
    support::TestRandom random(10);
    const Dielectric glass{.specular = Rgbf(1), .sampling = core::Weights{0.5f, 0, 0, 0.5f}};
    for (int i = 0; i < 10'000; ++i)
        ASSERT_FALSE(bsdfOf(glass).sample(nextDirection(random), nextDraw(random), 1.5f).valid);
    const Dielectric through{.sampling = refraction};
    for (int i = 0; i < 10'000; ++i) {
        const auto sample = bsdfOf(through).sample(nextDirection(random), nextDraw(random), 1.5f);
        ASSERT_TRUE(!sample.valid || sample.wi.z < 0);
    }
}

// Light sampling knows the lights that the highlight stands for; a refracted ray meets them itself.
TEST(Dielectric, IsLitInReflectionsWhereItHasAHighlight) {
    const Vec3f wo(0.6f, 0, 0.8f);
    for (const double perturbation : {0.0, 10.0})
        for (const Rgbf& specular : {Rgbf(0), Rgbf(0, 0, 0.1f), Rgbf(1)}) {
            const Dielectric glass{.specular = specular, .perturbation = perturbation};
            const auto reflected = sampleBy(glass, reflection, wo, 1.5f),
                       through = sampleBy(glass, refraction, wo, 1.5f);
            EXPECT_TRUE(reflected.isDelta && through.isDelta);
            EXPECT_EQ(reflected.isLit, specular != Rgbf(0));
            EXPECT_FALSE(through.isLit);
            EXPECT_FALSE(reflected.isDiffuse || through.isDiffuse);
        }
}

TEST(Dielectric, HasTheReportsHighlight) {
    const Dielectric glass{.specular = Rgbf(0.2f, 0.5f, 1)};
    support::TestRandom random(11);
    for (int i = 0; i < 100'000; ++i) {
        const Vec3f wo = nextDirection(random);
        const Vec3f wi = i % 2 == 0 ? nextDirection(random) : nextDirectionNear({-wo.x, -wo.y, wo.z}, 0.3, random);
        // r is where the light would be mirrored to.
        const double cosine = -double(wi.x) * wo.x - double(wi.y) * wo.y + double(wi.z) * wo.z;
        const double highlight = wi.z > 0 && wo.z > 0 ? std::pow(std::max(0.0, cosine), 10) : 0;
        for (int channel = 0; channel < 3; ++channel)
            ASSERT_NEAR(bsdfOf(glass).eval(wo, wi)[channel], glass.specular.value[channel] * highlight, 2e-6);
    }
    EXPECT_EQ(bsdfOf(glass).eval(Vec3f(0, 0, 1), Vec3f(0, 0, 1)), glass.specular.value);
    EXPECT_EQ(bsdfOf(Dielectric{}).eval(Vec3f(0, 0, 1), Vec3f(0, 0, 1)), Rgbf(0));
    EXPECT_EQ(bsdfOf(glass).pdfW(Vec3f(0, 0, 1), Vec3f(0, 0, 1)), 0);
}

TEST(Dielectric, AbsorbsByBeersLaw) {
    const Dielectric glass{.absorption = Rgbf(0, 0.3f, 12)};
    for (const float length : {0.f, 1e-6f, 0.5f, 1.f, 7.f}) {
        const Rgbf left = glass.interior()->transmittance(length);
        for (int channel = 0; channel < 3; ++channel) {
            const double expected = std::exp(-double(glass.absorption[channel]) * length);
            EXPECT_NEAR(left[channel], expected, 1e-6 * expected + 1e-37) << length;
        }
    }
    EXPECT_EQ(glass.interior()->transmittance(core::infinity), Rgbf(1, 0, 0));
    EXPECT_EQ(Dielectric{.absorption = Rgbf(1e-30f)}.interior()->transmittance(core::infinity), Rgbf(0));
    EXPECT_EQ(Dielectric{.absorption = Rgbf(1e18f)}.interior()->transmittance(1e30f), Rgbf(0));
}

TEST(Dielectric, IsFiniteForEveryIndex) {
    for (const float n : {1e-30f, 1e-12f, 1e-6f, 0.999999f, 1.f, 1.000001f, 1e6f, 1e12f, 1e30f})
        for (const double cosine : {1.0, 1 - 1e-7, 0.5, 1e-3, 1e-7, 1e-30}) {
            const Vec3f wo = {std::sqrt(1 - cosine * cosine), 0, cosine};
            for (const float u : {0.f, 0.04f, 0.5f, 1 - 0x1p-24f}) {
                const auto sample = bsdfOf(Dielectric{}).sample(wo, BsdfDraw<float>{u, {0.5f, 0.5f}}, n);
                EXPECT_TRUE(sample.valid) << n << " " << cosine << " " << u;
                EXPECT_NEAR(glm::length(sample.wi), 1, 1e-5) << n << " " << cosine;
                EXPECT_TRUE(std::isfinite(sample.weight.x) && sample.weight.x >= 0) << n << " " << cosine << " " << u;
            }
        }
}

}  // namespace
}  // namespace materials
