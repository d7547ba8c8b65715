// Each check of bsdf_checks.h and albedo.h is seen to fail: on diffuse surfaces that have one fault each.
#include <gtest/gtest.h>

#include "materials/albedo.h"
#include "materials/diffuse.h"

namespace materials {
namespace {

using core::Vec3;
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
struct DroppedCosine : Diffuse {
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        BsdfSample<Real> sample = Diffuse::sample(wo, u, n);
        sample.weight /= sample.wi.z;
        return sample;
    }
};

TEST(PlantedFault, ADroppedCosineIsFound) {
    const DroppedCosine faulty{grey};
    EXPECT_NE(firstSampleFault(faulty, wo), "");
    EXPECT_FALSE(albedoIsAccepted(faulty, wo));
}

// Directions by the cosine, which pdf and weight know nothing of.
struct CosineSampler : Diffuse {
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        return Diffuse::sample(wo, BsdfDraw<Real>{u.method, {core::sqrt(u.place.x), u.place.y}}, n);
    }
};

TEST(PlantedFault, AnotherSamplerIsFound) {
    const CosineSampler faulty{grey};
    EXPECT_FALSE(testSampling(faulty, wo).accepted);
    EXPECT_FALSE(albedoIsAccepted(faulty, wo));
}

// A pdf 2 % too large, everywhere it is used: sample, pdf and weight agree.
struct LargePdf : Diffuse {
    template<class Real>
    Real pdfW(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        return Diffuse::pdfW(wo, wi) * Real(1.02f);
    }
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        BsdfSample<Real> sample = Diffuse::sample(wo, u, n);
        sample.pdfW *= Real(1.02f);
        sample.weight /= Real(1.02f);
        return sample;
    }
};

TEST(PlantedFault, APdfTwoPerCentTooLargeIsFound) {
    const LargePdf faulty{grey};
    EXPECT_EQ(firstSampleFault(faulty, wo), "");
    const support::DistributionResult result = testSampling(faulty, wo);
    EXPECT_FALSE(result.accepted);
    EXPECT_NEAR(result.integral, 1.02, 1e-3);
    EXPECT_FALSE(albedoIsAccepted(faulty, wo));
}

// A pdf of its own, off by 0.02 %.
struct OtherPdf : Diffuse {
    template<class Real>
    Real pdfW(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        return Diffuse::pdfW(wo, wi) * Real(1.0002f);
    }
};

TEST(PlantedFault, APdfThatSamplesDoNotHaveIsFound) {
    EXPECT_NE(firstSampleFault(OtherPdf{grey}, wo), "");
}

// One sample in 2^13 goes through the surface.
struct Leaking : Diffuse {
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        BsdfSample<Real> sample = Diffuse::sample(wo, u, n);
        sample.wi.z = core::select(u.place.y < Real(0x1p-13f), -sample.wi.z, sample.wi.z);
        return sample;
    }
};

TEST(PlantedFault, ASampleBelowTheSurfaceIsFound) {
    const Leaking faulty{grey};
    EXPECT_FALSE(testSampling(faulty, wo).accepted);
    EXPECT_NE(firstSampleFault(faulty, wo), "");
}

// One draw in 1000 gives no sample, and the pdf does not say so.
struct Missing : Diffuse {
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        BsdfSample<Real> sample = Diffuse::sample(wo, u, n);
        sample.valid = sample.valid & (u.place.y >= Real(1e-3f));
        return sample;
    }
};

TEST(PlantedFault, ADrawWithoutASampleThatThePdfDeniesIsFound) {
    EXPECT_FALSE(testSampling(Missing{grey}, wo).accepted);
}

// Depends on where light goes to, by 0.002 % at most.
struct OneWay : Diffuse {
    template<class Real>
    core::Rgb<Real> eval(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        return Diffuse::eval(wo, wi) * (Real(1) + wo.z * Real(2e-5f));
    }
};

TEST(PlantedFault, WhatIsNotReciprocalIsFound) {
    EXPECT_NE(firstReciprocityFault(OneWay{grey}), "");
}

// Draws half the directions that it reflects to, as its pdf says.
struct HalfSampled : Diffuse {
    template<class Real>
    Real pdfW(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        return core::select(wi.x > Real(0), Diffuse::pdfW(wo, wi), Real(0));
    }
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        BsdfSample<Real> sample = Diffuse::sample(wo, u, n);
        sample.valid = sample.valid & (sample.wi.x > Real(0));
        return sample;
    }
};

TEST(PlantedFault, LightThatNoSampleFindsIsFound) {
    const HalfSampled faulty{grey};
    EXPECT_EQ(firstSampleFault(faulty, wo), "");
    EXPECT_TRUE(testSampling(faulty, wo).accepted);
    EXPECT_FALSE(albedoIsAccepted(faulty, wo));
}

// Reflects light from below the surface.
struct Transparent : Diffuse {
    template<class Real>
    core::Rgb<Real> eval(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        return Diffuse::eval(wo, Vec3<Real>(wi.x, wi.y, core::abs(wi.z)));
    }
};

TEST(PlantedFault, LightThroughTheSurfaceIsFound) {
    EXPECT_NE(firstFaultBelow(Transparent{grey}), "");
}

// Without its factor 1 / pi.
TEST(PlantedFault, MoreLightThanArrivesIsFound) {
    EXPECT_GT(albedo(Diffuse{.reflectance = grey.reflectance * core::pi}, wo, mean), 1 + 1e-5);
}

}  // namespace
}  // namespace materials
