// The planted_*_test.cpp see each of these checks fail.
#include "materials/bsdf_checks.h"
#include "materials/parameter_sets.h"

#include <gtest/gtest.h>

namespace materials {
namespace {

template<class M>
class BsdfSampling : public testing::Test {};
TYPED_TEST_SUITE(BsdfSampling, EveryMaterial, MaterialName);

TYPED_TEST(BsdfSampling, FollowsThePdf) {
    const auto sets = parameterSets<TypeParam>();
    for (std::size_t i = 0; i < sets.size(); ++i) {
        for (const core::Vec3f& wo : outgoingDirections()) {
            const support::DistributionResult result = testSampling(sets[i], wo);
            EXPECT_TRUE(result.accepted) << "set " << i << ", wo " << text(wo) << ": " << result.text;
            EXPECT_TRUE(sumsToOne(result)) << "set " << i << ", wo " << text(wo) << ": " << result.text;
        }
    }
}

TYPED_TEST(BsdfSampling, AgreesWithEvalAndPdf) {
    for (const TypeParam& material : parameterSets<TypeParam>())
        for (const core::Vec3f& wo : outgoingDirections()) EXPECT_EQ(firstSampleFault(material, wo), "");
}

// The corners and edges of the unit cube, and the numbers next to them.
TYPED_TEST(BsdfSampling, HoldsAtTheEdgesOfTheCube) {
    const float coordinates[] = {0, 0x1p-24f, 0.25f, 0.5f, 0.75f, 1 - 0x1p-24f};
    for (const TypeParam& material : parameterSets<TypeParam>())
        for (const core::Vec3f& wo : outgoingDirections())
            for (const float method : coordinates)
                for (const float u : coordinates)
                    for (const float v : coordinates) {
                        const BsdfDraw<float> draw{method, {u, v}};
                        EXPECT_EQ(sampleFault(material, wo, material.template sample<float>(wo, draw, 1.f)), "");
                    }
}

TYPED_TEST(BsdfSampling, GivesNothingFromBelow) {
    for (const TypeParam& material : parameterSets<TypeParam>()) {
        EXPECT_EQ(firstFaultBelow(material), "");
        support::TestRandom random(6);
        for (int i = 0; i < 10'000; ++i) {
            core::Vec3f wo = nextDirection(random);
            wo.z = -wo.z;
            ASSERT_FALSE(draw(material, wo, random).valid) << text(wo);
        }
    }
}

}  // namespace
}  // namespace materials
