// The checks of bsdf_checks.h, albedo.h and shirley_paper.h are seen to fail: on Shirley's materials with one fault
// each.
#include <gtest/gtest.h>

#include "materials/albedo.h"
#include "materials/shirley_paper.h"

namespace materials {
namespace {

using core::Rgb;
using core::Rgbf;
using core::Vec3;
using core::Vec3f;

const Vec3f wo(0.6f, 0.3f, std::sqrt(0.55f));
const Shirley brushed{.diffuse = Rgbf(0.4f), .specular = Rgbf(0.3f), .exponents = {30, 300}};
const Shirley onlyHighlight{.diffuse = Rgbf(0), .exponents = {30, 300}, .sampling = core::Weights{0, 0, 0, 1}};

TEST(PlantedShirleyFault, NoneIsFoundInShirley) {
    for (const Shirley& material : {brushed, onlyHighlight}) {
        EXPECT_TRUE(testSampling(material, wo).accepted);
        EXPECT_EQ(firstSampleFault(material, wo), "");
        EXPECT_EQ(firstReciprocityFault(material), "");
        EXPECT_EQ(firstPaperFault(material), "");
        EXPECT_TRUE(albedoIsAccepted(material, wo));
    }
}

// The highlight is R_s from every direction: Shirley's own at R_s = 1 is free of Fresnel.
struct WithoutFresnel : Shirley {
    template<class Real>
    Rgb<Real> eval(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        const Shirley highlight{.diffuse = Rgbf(0), .specular = specular, .exponents = exponents};
        const Shirley mirror{.diffuse = Rgbf(0), .specular = Rgbf(1), .exponents = exponents};
        const Rgb<Real> base = Shirley::eval(wo, wi) - highlight.eval(wo, wi);
        return base + mirror.eval(wo, wi) * core::broadcast<Real>(specular);
    }
};

TEST(PlantedShirleyFault, ADroppedFresnelTermIsFound) {
    const WithoutFresnel faulty{brushed};
    EXPECT_NE(firstPaperFault(faulty), "");
    const Vec3f flat = outgoingDirections()[2];
    EXPECT_LT(albedo(faulty, flat, mean), albedo(brushed, flat, mean) - 0.05);
}

// The half vector's density for the direction's own.
struct WithoutJacobian : Shirley {
    template<class Real>
    Real pdfW(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        const Vec3<Real> sum = wo + wi;
        return Shirley::pdfW(wo, wi) * Real(2) * core::sqrt(glm::dot(sum, sum));
    }
};

TEST(PlantedShirleyFault, AMissingJacobianIsFound) {
    const WithoutJacobian faulty{onlyHighlight};
    EXPECT_NE(firstSampleFault(faulty, wo), "");
    const auto result = testSampling(faulty, wo);
    EXPECT_FALSE(result.accepted);
    EXPECT_FALSE(sumsToOne(result));
}

// 2 % too large in the highlight's part of the mixture alone, in samples, weights and pdf.
struct LargeLobe : Shirley {
    template<class Real>
    Real pdfW(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        Shirley lobe = *this;
        lobe.sampling = core::Weights{0, 0, 0, 1};
        return Shirley::pdfW(wo, wi) + lobe.pdfW(wo, wi) * Real((*sampling)[3] * 0.02f);
    }
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        BsdfSample<Real> sample = Shirley::sample(wo, u, n);
        const Real right = sample.pdfW;
        sample.pdfW = pdfW(wo, sample.wi);
        sample.weight *= right / sample.pdfW;
        return sample;
    }
};

TEST(PlantedShirleyFault, APdfTwoPerCentTooLargeInOneLobeIsFound) {
    LargeLobe faulty{brushed};
    faulty.sampling = core::Weights{0.5f, 0, 0, 0.5f};
    EXPECT_EQ(firstSampleFault(faulty, wo), "");
    const auto result = testSampling(faulty, wo);
    EXPECT_FALSE(result.accepted);
    EXPECT_FALSE(sumsToOne(result));
}

// Half vectors as if nu were nv.
struct SwappedSampler : Shirley {
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        Shirley swapped = *this;
        swapped.exponents = {exponents.y, exponents.x};
        BsdfSample<Real> sample = swapped.sample(wo, u, n);
        sample.pdfW = Shirley::pdfW(wo, sample.wi);
        sample.weight = Shirley::eval(wo, sample.wi) / sample.pdfW;
        return sample;
    }
};

TEST(PlantedShirleyFault, ASamplerOfTheOtherAxisIsFound) {
    const SwappedSampler faulty{onlyHighlight};
    EXPECT_FALSE(testSampling(faulty, wo).accepted);
    EXPECT_FALSE(albedoIsAccepted(faulty, wo));
}

// The exponents' mean for their mixture by the half vector's longitude.
struct MeanExponent : Shirley {
    template<class Real>
    Rgb<Real> eval(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        Shirley round = *this;
        round.exponents = core::Vec2f((exponents.x + exponents.y) / 2);
        return round.eval(wo, wi);
    }
};

TEST(PlantedShirleyFault, AWrongCombinationOfExponentsIsFound) {
    EXPECT_NE(firstPaperFault(MeanExponent{brushed}), "");
    EXPECT_NE(firstSampleFault(MeanExponent{brushed}, wo), "");
}

// The cosine of wo alone for the larger of both, which makes the model reciprocal.
struct OneCosine : Shirley {
    template<class Real>
    Rgb<Real> eval(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        return Shirley::eval(wo, wi) * (core::max(wo.z, wi.z) / wo.z);
    }
};

TEST(PlantedShirleyFault, ADenominatorThatIsNotReciprocalIsFound) {
    EXPECT_NE(firstReciprocityFault(OneCosine{onlyHighlight}), "");
    EXPECT_NE(firstPaperFault(OneCosine{onlyHighlight}), "");
}

// A cone of the perturbed reflection 2 % smaller than the one of the pdf.
struct NarrowCone : Shirley {
    template<class Real>
    BsdfSample<Real> sample(const Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& n) const {
        return Shirley::sample(wo, BsdfDraw<Real>{u.method, {u.place.x * Real(0.98f), u.place.y}}, n);
    }
};

TEST(PlantedShirleyFault, AConeTwoPerCentTooSmallIsFound) {
    NarrowCone faulty{brushed};
    faulty.sampling = core::Weights{0, 1, 0, 0};
    EXPECT_FALSE(testSampling(faulty, wo).accepted);
}

}  // namespace
}  // namespace materials
