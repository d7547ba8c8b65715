#include "materials/diffuse.h"

#include <gtest/gtest.h>

#include "materials/bsdf_checks.h"
#include "materials/parameter_sets.h"

namespace materials {
namespace {

using core::Rgbf;
using core::Vec3f;

const Diffuse orange{Rgbf(0.8f, 0.3f, 0)};

TEST(Diffuse, ReflectsEvenlyAndOnlyOnTheSideOfTheNormal) {
    const Rgbf f = orange.reflectance * (1 / core::pi);
    const Vec3f above(0.6f, 0, 0.8f), flat(-0.99995f, 0, 0.01f), below(0, 0.6f, -0.8f);
    EXPECT_EQ(orange.eval(above, flat), f);
    EXPECT_EQ(orange.eval(flat, above), f);
    EXPECT_EQ(orange.eval(above, below), Rgbf(0));
    EXPECT_EQ(orange.eval(below, above), Rgbf(0));
    EXPECT_EQ(orange.eval(below, below), Rgbf(0));
}

TEST(Diffuse, DrawsUniformlyOverTheHemisphere) {
    const Vec3f above(0.6f, 0, 0.8f), below(0, 0.6f, -0.8f);
    EXPECT_FLOAT_EQ(orange.pdfW(above, above), 1 / (2 * core::pi));
    EXPECT_EQ(orange.pdfW(above, below), 0);
    EXPECT_EQ(orange.pdfW(below, above), 0);
}

TEST(Diffuse, GivesNoSampleFromBelowOrAlongTheSurface) {
    const core::Vec2f middle(0.5f, 0.5f);
    EXPECT_TRUE(orange.sample(Vec3f(0.6f, 0, 0.8f), middle).valid);
    EXPECT_FALSE(orange.sample(Vec3f(0.6f, 0, -0.8f), middle).valid);
    EXPECT_FALSE(orange.sample(Vec3f(1, 0, 0), middle).valid);
    const bool alongTheSurface = orange.sample(Vec3f(0, 0, 1), core::Vec2f(0, 0.5f)).valid;
    EXPECT_FALSE(alongTheSurface);
}

// f * cos over the hemisphere is R_d, wherever the light goes to.
TEST(Diffuse, HasItsReflectanceAsAlbedo) {
    for (const Diffuse& material : parameterSets<Diffuse>())
        for (const Vec3f& wo : outgoingDirections())
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(albedo(material, wo, channel), material.reflectance[channel], 2e-6);
}

TEST(Diffuse, HasItsReflectanceAsMeanWeight) {
    for (const Diffuse& material : parameterSets<Diffuse>()) {
        const auto weights = sampledAlbedo(material, Vec3f(0.6f, 0, 0.8f));
        for (int channel = 0; channel < 3; ++channel) {
            const support::TestResult result = support::zTest(weights[channel], material.reflectance[channel]);
            EXPECT_LT(std::abs(result.statistic), 3) << result.text;
        }
    }
}

TEST(Diffuse, ReflectsAmbientLightByItsReflectance) {
    EXPECT_EQ(orange.ambientReflectance(), orange.reflectance);
    EXPECT_EQ(Diffuse{}.reflectance, Rgbf(0.5f));
}

}  // namespace
}  // namespace materials
