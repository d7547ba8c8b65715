// planted_fault_test.cpp sees each of these checks fail.
#include "materials/bsdf_checks.h"
#include "materials/parameter_sets.h"

#include <gtest/gtest.h>

namespace materials {
namespace {

template<class M>
class BsdfReflection : public testing::Test {};
TYPED_TEST_SUITE(BsdfReflection, EveryMaterial, MaterialName);

TYPED_TEST(BsdfReflection, IsReciprocal) {
    for (const TypeParam& material : parameterSets<TypeParam>()) EXPECT_EQ(firstReciprocityFault(material), "");
}

TYPED_TEST(BsdfReflection, IsNeverNegativeAndReflectsNoMoreThanArrives) {
    for (const TypeParam& material : parameterSets<TypeParam>()) {
        for (const core::Vec3f& wo : outgoingDirections()) {
            for (int channel = 0; channel < 3; ++channel) {
                const double part = albedo(material, wo, channel);
                EXPECT_GE(part, 0) << "wo " << text(wo);
                EXPECT_LE(part, 1 + 1e-6) << "wo " << text(wo);
            }
        }
    }
}

// Sampling misses nothing of f, and its weights are right.
TYPED_TEST(BsdfReflection, IsTheSameBySamplingAsByQuadrature) {
    for (const TypeParam& material : parameterSets<TypeParam>()) {
        for (const core::Vec3f& wo : outgoingDirections()) {
            const auto weights = sampledAlbedo(material, wo);
            for (int channel = 0; channel < 3; ++channel) {
                const support::TestResult result = support::zTest(weights[channel], albedo(material, wo, channel));
                EXPECT_TRUE(result.accepted) << "wo " << text(wo) << ", channel " << channel << ": " << result.text;
            }
        }
    }
}

}  // namespace
}  // namespace materials
