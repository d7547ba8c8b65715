#include "materials/diffuse.h"

#include <gtest/gtest.h>

#include "materials/albedo.h"
#include "materials/parameter_sets.h"

namespace materials {
namespace {

using core::Rgbf;
using core::Vec3f;

const Diffuse orange{.reflectance = Rgbf(0.8f, 0.3f, 0)};
const DiffuseBsdf<float> bsdf = bsdfOf(orange);

TEST(Diffuse, ReflectsEvenlyAndOnlyOnTheSideOfTheNormal) {
    const Rgbf f = orange.reflectance.value * (1 / core::pi);
    const Vec3f above(0.6f, 0, 0.8f), flat(-0.99995f, 0, 0.01f), below(0, 0.6f, -0.8f);
    EXPECT_EQ(bsdf.eval(above, flat), f * 0.01f);
    EXPECT_EQ(bsdf.eval(flat, above), f * 0.8f);
    EXPECT_EQ(bsdf.eval(above, below), Rgbf(0));
    EXPECT_EQ(bsdf.eval(below, above), Rgbf(0));
    EXPECT_EQ(bsdf.eval(below, below), Rgbf(0));
}

TEST(Diffuse, DrawsUniformlyOverTheHemisphereUnlessToldOtherwise) {
    const Vec3f above(0.6f, 0, 0.8f), below(0, 0.6f, -0.8f);
    EXPECT_FLOAT_EQ(bsdf.pdfW(above, above), 1 / (2 * core::pi));
    EXPECT_EQ(bsdf.pdfW(above, below), 0);
    EXPECT_EQ(bsdf.pdfW(below, above), 0);
    const float byTheCosine = bsdf.pdfW<core::CosineHemisphere>(Vec3f(0, 0, 1), above);
    EXPECT_FLOAT_EQ(byTheCosine, 0.8f / core::pi);
}

TEST(Diffuse, GivesNoSampleFromBelowOrAlongTheSurface) {
    const BsdfDraw<float> middle{0.5f, {0.5f, 0.5f}}, flat{0.5f, {0, 0.5f}};
    EXPECT_TRUE(bsdf.sample(Vec3f(0.6f, 0, 0.8f), middle, 1.f).valid);
    EXPECT_FALSE(bsdf.sample(Vec3f(0.6f, 0, -0.8f), middle, 1.f).valid);
    EXPECT_FALSE(bsdf.sample(Vec3f(1, 0, 0), middle, 1.f).valid);
    EXPECT_FALSE(bsdf.sample(Vec3f(0, 0, 1), flat, 1.f).valid);
}

// f * cos over the hemisphere is R_d, wherever the light goes to.
TEST(Diffuse, HasItsReflectanceAsAlbedo) {
    for (const Vec3f& wo : outgoingDirections())
        for (int channel = 0; channel < 3; ++channel) {
            const auto value = [&](const Rgbf& c) { return c[channel]; };
            EXPECT_NEAR(albedo(orange, wo, value), orange.reflectance.value[channel], 2e-6);
            EXPECT_EQ(orange.albedo<float>(SomePoint{})[channel], orange.reflectance.value[channel]);
        }
}

// Light sampling knows all of a diffuse surface's directions, the sharply reflected ones too.
TEST(Diffuse, IsLitWhateverTheMethod) {
    Diffuse mixed = orange;
    mixed.sampling = core::Weights{0.5f, 0.5f, 0, 0};
    const Vec3f wo(0.6f, 0, 0.8f);
    for (const float method : {0.25f, 0.75f}) {
        const BsdfSample<float> sample = bsdfOf(mixed).sample(wo, BsdfDraw<float>{method, {0.5f, 0.5f}}, 1.f);
        EXPECT_TRUE(sample.valid && sample.isLit && !sample.isDelta) << method;
        EXPECT_EQ(sample.isDiffuse, method < 0.5f) << method;
    }
}

TEST(Diffuse, ReflectsAmbientLightByItsReflectance) {
    EXPECT_EQ(orange.ambientReflectance<float>(SomePoint{}), orange.reflectance.value);
    EXPECT_EQ(Diffuse{}.reflectance.value, Rgbf(0.5f));
}

}  // namespace
}  // namespace materials
