// planted_fault_test.cpp sees each of these checks fail.
#include "materials/bsdf_checks.h"
#include "materials/parameter_sets.h"

#include <gtest/gtest.h>

namespace materials {
namespace {

template<class M>
class BsdfSampling : public testing::Test {};
TYPED_TEST_SUITE(BsdfSampling, EveryMaterial, MaterialName);

TYPED_TEST(BsdfSampling, FollowsThePdf) {
    for (const TypeParam& material : parameterSets<TypeParam>()) {
        for (const core::Vec3f& wo : outgoingDirections()) {
            const support::DistributionResult result = testSampling(material, wo);
            EXPECT_TRUE(result.accepted) << "wo " << text(wo) << ": " << result.text;
            EXPECT_NEAR(result.integral + result.missed, 1, 1e-3) << "wo " << text(wo);
        }
    }
}

TYPED_TEST(BsdfSampling, AgreesWithEvalAndPdf) {
    for (const TypeParam& material : parameterSets<TypeParam>())
        for (const core::Vec3f& wo : outgoingDirections()) EXPECT_EQ(firstSampleFault(material, wo), "");
}

// The corners and edges of the unit square, and the numbers next to them.
TYPED_TEST(BsdfSampling, HoldsAtTheEdgesOfTheSquare) {
    const float coordinates[] = {0, 0x1p-24f, 0.25f, 0.5f, 0.75f, 1 - 0x1p-24f};
    for (const TypeParam& material : parameterSets<TypeParam>())
        for (const core::Vec3f& wo : outgoingDirections())
            for (const float u : coordinates)
                for (const float v : coordinates)
                    EXPECT_EQ(sampleFault(material, wo, material.template sample<float>(wo, {u, v})), "");
}

}  // namespace
}  // namespace materials
