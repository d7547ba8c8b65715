// Each check of bsdf_checks.h and albedo.h is seen to fail: on diffuse surfaces that have one fault each.
#include <gtest/gtest.h>

#include "materials/albedo.h"
#include "materials/diffuse.h"
#include "materials/faulty.h"

namespace materials {
namespace {

using core::Vec3f;

const Vec3f wo(0.6f, 0, 0.8f);
const Diffuse grey;

TEST(PlantedFault, NoneIsFoundInDiffuse) {
    EXPECT_TRUE(testSampling(grey, wo).accepted);
    EXPECT_EQ(firstSampleFault(grey, wo), "");
    EXPECT_EQ(firstReciprocityFault(grey), "");
    EXPECT_EQ(firstFaultBelow(grey), "");
    EXPECT_TRUE(albedoIsAccepted(grey, wo));
}

// The weight is that of a uniform pdf, but without its cosine.
struct DroppedCosine : DiffuseBsdf<float> {
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        BsdfSample<float> sample = DiffuseBsdf::sample(wo, u, n);
        sample.weight /= sample.wi.z;
        return sample;
    }
};

TEST(PlantedFault, ADroppedCosineIsFound) {
    const Faulty<Diffuse, DroppedCosine> faulty{grey};
    EXPECT_NE(firstSampleFault(faulty, wo), "");
    EXPECT_FALSE(albedoIsAccepted(faulty, wo));
}

// Directions by the cosine, which pdf and weight know nothing of.
struct CosineSampler : DiffuseBsdf<float> {
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        return DiffuseBsdf::sample(wo, BsdfDraw<float>{u.method, {core::sqrt(u.place.x), u.place.y}}, n);
    }
};

TEST(PlantedFault, AnotherSamplerIsFound) {
    const Faulty<Diffuse, CosineSampler> faulty{grey};
    EXPECT_FALSE(testSampling(faulty, wo).accepted);
    EXPECT_FALSE(albedoIsAccepted(faulty, wo));
}

// A pdf 2 % too large, everywhere it is used: sample, pdf and weight agree.
struct LargePdf : DiffuseBsdf<float> {
    float pdfW(const Vec3f& wo, const Vec3f& wi) const { return DiffuseBsdf::pdfW(wo, wi) * 1.02f; }
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        BsdfSample<float> sample = DiffuseBsdf::sample(wo, u, n);
        sample.pdfW *= 1.02f;
        sample.weight /= 1.02f;
        return sample;
    }
};

TEST(PlantedFault, APdfTwoPerCentTooLargeIsFound) {
    const Faulty<Diffuse, LargePdf> faulty{grey};
    EXPECT_EQ(firstSampleFault(faulty, wo), "");
    const support::DistributionResult result = testSampling(faulty, wo);
    EXPECT_FALSE(result.accepted);
    EXPECT_NEAR(result.integral, 1.02, 1e-3);
    EXPECT_FALSE(albedoIsAccepted(faulty, wo));
}

// A pdf of its own, off by 0.02 %.
struct OtherPdf : DiffuseBsdf<float> {
    float pdfW(const Vec3f& wo, const Vec3f& wi) const { return DiffuseBsdf::pdfW(wo, wi) * 1.0002f; }
};

TEST(PlantedFault, APdfThatSamplesDoNotHaveIsFound) {
    EXPECT_NE(firstSampleFault(Faulty<Diffuse, OtherPdf>{grey}, wo), "");
}

// One sample in 2^13 goes through the surface.
struct Leaking : DiffuseBsdf<float> {
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        BsdfSample<float> sample = DiffuseBsdf::sample(wo, u, n);
        sample.wi.z = core::select(u.place.y < 0x1p-13f, -sample.wi.z, sample.wi.z);
        return sample;
    }
};

TEST(PlantedFault, ASampleBelowTheSurfaceIsFound) {
    const Faulty<Diffuse, Leaking> faulty{grey};
    EXPECT_FALSE(testSampling(faulty, wo).accepted);
    EXPECT_NE(firstSampleFault(faulty, wo), "");
}

// One draw in 1000 gives no sample, and the pdf does not say so.
struct Missing : DiffuseBsdf<float> {
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        BsdfSample<float> sample = DiffuseBsdf::sample(wo, u, n);
        sample.valid = sample.valid & (u.place.y >= 1e-3f);
        return sample;
    }
};

TEST(PlantedFault, ADrawWithoutASampleThatThePdfDeniesIsFound) {
    EXPECT_FALSE(testSampling(Faulty<Diffuse, Missing>{grey}, wo).accepted);
}

// Depends on where light goes to, by 0.002 % at most.
struct OneWay : DiffuseBsdf<float> {
    core::Rgbf eval(const Vec3f& wo, const Vec3f& wi) const { return DiffuseBsdf::eval(wo, wi) * (1 + wo.z * 2e-5f); }
};

TEST(PlantedFault, WhatIsNotReciprocalIsFound) {
    EXPECT_NE(firstReciprocityFault(Faulty<Diffuse, OneWay>{grey}), "");
}

// Draws half the directions that it reflects to, as its pdf says.
struct HalfSampled : DiffuseBsdf<float> {
    float pdfW(const Vec3f& wo, const Vec3f& wi) const {
        return core::select(wi.x > 0, DiffuseBsdf::pdfW(wo, wi), 0.f);
    }
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        BsdfSample<float> sample = DiffuseBsdf::sample(wo, u, n);
        sample.valid = sample.valid & (sample.wi.x > 0);
        return sample;
    }
};

TEST(PlantedFault, LightThatNoSampleFindsIsFound) {
    const Faulty<Diffuse, HalfSampled> faulty{grey};
    EXPECT_EQ(firstSampleFault(faulty, wo), "");
    EXPECT_TRUE(testSampling(faulty, wo).accepted);
    EXPECT_FALSE(albedoIsAccepted(faulty, wo));
}

// Reflects light from below the surface.
struct Transparent : DiffuseBsdf<float> {
    core::Rgbf eval(const Vec3f& wo, const Vec3f& wi) const {
        return DiffuseBsdf::eval(wo, Vec3f(wi.x, wi.y, core::abs(wi.z)));
    }
};

TEST(PlantedFault, LightThroughTheSurfaceIsFound) {
    EXPECT_NE(firstFaultBelow(Faulty<Diffuse, Transparent>{grey}), "");
}

// Without its factor 1 / pi.
TEST(PlantedFault, MoreLightThanArrivesIsFound) {
    EXPECT_GT(albedo(Diffuse{.reflectance = grey.reflectance.value * core::pi}, wo, mean), 1 + 1e-5);
}

}  // namespace
}  // namespace materials
