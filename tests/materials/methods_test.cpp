// The choice of a method, and the perturbed reflection.
#include "materials/methods.h"

#include <gtest/gtest.h>

#include "core/frame.h"
#include "materials/bsdf_of.h"
#include "materials/dielectric.h"
#include "materials/directions.h"
#include "support/histogram.h"

namespace materials {
namespace {

using core::Vec3f;

// Every float that is drawn chooses one method, each as often as its probability says.
TEST(Choose, TakesEachMethodByItsProbability) {
    const core::Weights mixtures[] = {{1, 0, 0, 0},
                                      {0, 1, 0, 0},
                                      {0, 0, 1, 0},
                                      {0, 0, 0, 1},
                                      {0.5f, 0, 0.5f, 0},
                                      {0.1f, 0.2f, 0.3f, 0.4f},
                                      {0, 1 / 3.f, 0, 2 / 3.f},
                                      {1 / 3.f, 1 / 3.f, 1 / 3.f, 0}};
    for (const core::Weights& weights : mixtures) {
        const Methods<float> p = methodsOf<float>(weights);
        std::array<int, 4> count{};
        constexpr int step = 7;
        for (int i = 0; i < 1 << 24; i += step) {
            const ChosenMethod<float> chosen = choose(p, static_cast<float>(i) * 0x1p-24f);
            const std::array<bool, 4> is{chosen.diffuse, chosen.reflective, chosen.refractive, chosen.shirley};
            ASSERT_EQ(is[0] + is[1] + is[2] + is[3], 1);
            for (int method = 0; method < 4; ++method) count[method] += is[method];
        }
        for (int method = 0; method < 4; ++method) {
            EXPECT_NEAR(count[method] * (step * 0x1p-24), weights[method], 1e-6)
                << core::optionText(std::optional(weights));
            EXPECT_EQ(count[method] == 0, weights[method] == 0);
        }
    }
}

TEST(Choose, NeverTakesAMethodOfProbability0) {
    support::TestRandom random(12);
    for (int i = 0; i < 200'000; ++i) {
        core::Weights weights;
        for (float& weight : weights) weight = random.next() < 0.5 ? 0 : nextFloat(random);
        float sum = weights[0] + weights[1] + weights[2] + weights[3];
        if (sum == 0) continue;
        for (float& weight : weights) weight /= sum;
        for (const float u : {0.f, 0x1p-24f, 1 - 0x1p-24f}) {
            const ChosenMethod<float> chosen = choose(methodsOf<float>(weights), u);
            const bool is[] = {chosen.diffuse, chosen.reflective, chosen.refractive, chosen.shirley};
            for (int method = 0; method < 4; ++method) ASSERT_FALSE(is[method] && weights[method] == 0) << u;
        }
    }
}

TEST(ConeHeight, IsOneMinusTheCosine) {
    for (const double degrees : {1e-3, 0.1, 1.0, 5.0, 45.0, 90.0}) {
        const double sine = std::sin(degrees * std::numbers::pi / 360);
        EXPECT_NEAR(coneHeight(degrees) / (2 * sine * sine), 1, 1e-6) << degrees;
    }
    EXPECT_EQ(coneHeight(0), 0);
}

// A blurred reflection in glass: depth in the cone by turn about its axis, uniform but for what is below the surface.
support::DistributionResult testCone(double degrees, const Vec3f& wo, double stretch) {
    const Dielectric glass{.sampling = core::Weights{0, 1, 0, 0}, .perturbation = degrees};
    const double height = 1 - std::cos(degrees * std::numbers::pi / 180);
    const core::Frame<double> frame{glm::dvec3(mirrored(wo))};
    const auto bsdf = bsdfOf(glass);
    support::SquareHistogram histogram;
    support::TestRandom random(13);
    for (int i = 0; i < 1'000'000; ++i) {
        const BsdfSample<float> sample = bsdf.sample(wo, nextDraw(random), 1.5f);
        if (!sample.valid) {
            histogram.addMiss();
            continue;
        }
        const glm::dvec3 local = frame.toLocal(glm::dvec3(sample.wi));
        const double depth = (1 - local.z / glm::length(local)) / height;
        const double turn = std::atan2(local.y, local.x) / (2 * std::numbers::pi);
        histogram.add(std::pow(std::min(depth, depth < 1 + 1e-4 ? 1.0 : depth), stretch), turn < 0 ? turn + 1 : turn);
    }
    return histogram.test([&](double depth, double turn) {
        const double z = 1 - depth * height, radius = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * turn;
        return frame.toWorld({radius * std::cos(phi), radius * std::sin(phi), z}).z > 0 ? 1 : 0;
    });
}

TEST(PerturbedReflection, IsUniformInItsCone) {
    for (const double degrees : {5.0, 30.0, 90.0})
        for (const Vec3f& wo : {Vec3f(0.6f, 0, 0.8f), outgoingDirections()[2]}) {
            const auto result = testCone(degrees, wo, 1);
            EXPECT_TRUE(result.accepted) << degrees << " degrees, wo " << text(wo) << ": " << result.text;
        }
}

// Planted fault: depths 2 % (root mean square) off uniform.
TEST(PerturbedReflection, IsToldFromOneThatIsNot) {
    EXPECT_FALSE(testCone(5, Vec3f(0.6f, 0, 0.8f), 1.03).accepted);
}

// In narrow cones rounding moves the directions at the rim, but loses next to none.
TEST(PerturbedReflection, KeepsItsSamplesInNarrowCones) {
    for (const double degrees : {1.0, 0.1, 0.01, 0.001}) {
        const float height = coneHeight(degrees);
        support::TestRandom random(14);
        int lost = 0;
        for (int i = 0; i < 100'000; ++i) {
            const Vec3f wo = glm::normalize(nextDirection(random) + Vec3f(0, 0, 0.1f));
            const Vec3f wi = perturbedReflection(wo, nextPoint(random), height);
            lost += core::uniformConePdfW(mirrored(wo), wi, height) == 0;
        }
        EXPECT_LT(lost, 100) << degrees;
    }
}

}  // namespace
}  // namespace materials
