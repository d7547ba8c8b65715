// The planted_*_test.cpp see each of these checks fail.
#include "materials/bsdf_checks.h"
#include "materials/each_hemisphere.h"

#include <gtest/gtest.h>

namespace materials {
namespace {

template<class M>
class BsdfSampling : public testing::Test {};
TYPED_TEST_SUITE(BsdfSampling, EveryMaterial, MaterialName);

TYPED_TEST(BsdfSampling, FollowsThePdf) {
    forEachSetAndHemisphere<TypeParam>([](const auto& material, const std::string& name) {
        for (const core::Vec3f& wo : outgoingDirections()) {
            const support::DistributionResult result = testSampling(material, wo);
            EXPECT_TRUE(result.accepted) << name << ", wo " << text(wo) << ": " << result.text;
            EXPECT_TRUE(sumsToOne(result)) << name << ", wo " << text(wo) << ": " << result.text;
        }
    });
}

TYPED_TEST(BsdfSampling, AgreesWithEvalAndPdf) {
    forEachSetAndHemisphere<TypeParam>([](const auto& material, const std::string& name) {
        for (const core::Vec3f& wo : outgoingDirections()) EXPECT_EQ(firstSampleFault(material, wo), "") << name;
    });
}

// The corners and edges of the unit cube, and the numbers next to them.
TYPED_TEST(BsdfSampling, HoldsAtTheEdgesOfTheCube) {
    const float coordinates[] = {0, 0x1p-24f, 0.25f, 0.5f, 0.75f, 1 - 0x1p-24f};
    forEachSetAndHemisphere<TypeParam>([&](const auto& material, const std::string& name) {
        const auto bsdf = bsdfOf(material);
        for (const core::Vec3f& wo : outgoingDirections())
            for (const float method : coordinates)
                for (const float u : coordinates)
                    for (const float v : coordinates) {
                        const BsdfDraw<float> draw{method, {u, v}};
                        EXPECT_EQ(sampleFault(material, wo, bsdf.sample(wo, draw, 1.f)), "") << name;
                    }
    });
}

TYPED_TEST(BsdfSampling, GivesNothingFromBelow) {
    forEachSetAndHemisphere<TypeParam>([](const auto& material, const std::string& name) {
        EXPECT_EQ(firstFaultBelow(material), "") << name;
        support::TestRandom random(6);
        for (int i = 0; i < 10'000; ++i) {
            core::Vec3f wo = nextDirection(random);
            wo.z = -wo.z;
            ASSERT_FALSE(draw(material, wo, random).valid) << name << ", wo " << text(wo);
        }
    });
}

}  // namespace
}  // namespace materials
