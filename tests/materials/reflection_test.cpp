// The planted_*_test.cpp see each of these checks fail.
#include "materials/albedo.h"
#include "materials/each_hemisphere.h"

#include <gtest/gtest.h>

namespace materials {
namespace {

template<class M>
class BsdfReflection : public testing::Test {};
TYPED_TEST_SUITE(BsdfReflection, EveryMaterial, MaterialName);

TYPED_TEST(BsdfReflection, IsReciprocal) {
    for (const TypeParam& material : parameterSets<TypeParam>()) {
        if (!isPhysical<TypeParam>) continue;
        EXPECT_EQ(firstReciprocityFault(material), "");
    }
}

TYPED_TEST(BsdfReflection, IsNeverNegativeAndReflectsNoMoreThanArrives) {
    const double most = isPhysical<TypeParam> ? 1 + 1e-5 : core::infinity;
    for (const TypeParam& material : parameterSets<TypeParam>()) {
        for (const core::Vec3f& wo : outgoingDirections()) {
            for (int channel = 0; channel < 3; ++channel) {
                bool isNegative = false;
                const auto value = [&](const core::Rgbf& c) {
                    isNegative = isNegative || !(c[channel] >= 0);
                    return c[channel];
                };
                EXPECT_LE(albedo(material, wo, value), most) << "wo " << text(wo);
                EXPECT_FALSE(isNegative) << "wo " << text(wo);
            }
        }
    }
}

// Sampling misses nothing of f, and its weights are right.
TYPED_TEST(BsdfReflection, IsTheSameBySamplingAsByQuadrature) {
    if (!isPhysical<TypeParam>) return;
    forEachSetAndHemisphere<TypeParam>([](const auto& material, const std::string& name) {
        for (const core::Vec3f& wo : outgoingDirections()) {
            const support::TestResult result =
                support::zTest(sampledWeight(material, wo), expectedWeight(material, wo));
            EXPECT_TRUE(result.accepted) << name << ", wo " << text(wo) << ": " << result.text;
        }
    });
}

}  // namespace
}  // namespace materials
