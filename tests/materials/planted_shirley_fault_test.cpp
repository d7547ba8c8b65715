// The checks of bsdf_checks.h, albedo.h and shirley_paper.h are seen to fail: on Shirley's materials with one fault
// each.
#include <gtest/gtest.h>

#include "materials/albedo.h"
#include "materials/faulty.h"
#include "materials/shirley_paper.h"

namespace materials {
namespace {

using core::Rgbf;
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
struct WithoutFresnel : ShirleyBsdf<float> {
    Rgbf eval(const Vec3f& wo, const Vec3f& wi) const {
        ShirleyBsdf highlight = *this, mirror = *this;
        highlight.diffuse = mirror.diffuse = Rgbf(0);
        mirror.specular = Rgbf(1);
        const Rgbf base = ShirleyBsdf::eval(wo, wi) - highlight.eval(wo, wi);
        return base + mirror.eval(wo, wi) * specular;
    }
};

TEST(PlantedShirleyFault, ADroppedFresnelTermIsFound) {
    const Faulty<Shirley, WithoutFresnel> faulty{brushed};
    EXPECT_NE(firstPaperFault(faulty), "");
    const Vec3f flat = outgoingDirections()[2];
    EXPECT_LT(albedo(faulty, flat, mean), albedo(brushed, flat, mean) - 0.05);
}

// The half vector's density for the direction's own.
struct WithoutJacobian : ShirleyBsdf<float> {
    float pdfW(const Vec3f& wo, const Vec3f& wi) const {
        const Vec3f sum = wo + wi;
        return ShirleyBsdf::pdfW(wo, wi) * 2 * core::sqrt(glm::dot(sum, sum));
    }
};

TEST(PlantedShirleyFault, AMissingJacobianIsFound) {
    const Faulty<Shirley, WithoutJacobian> faulty{onlyHighlight};
    EXPECT_NE(firstSampleFault(faulty, wo), "");
    const auto result = testSampling(faulty, wo);
    EXPECT_FALSE(result.accepted);
    EXPECT_FALSE(sumsToOne(result));
}

// 2 % too large in the highlight's part of the mixture alone, in samples, weights and pdf.
struct LargeLobe : ShirleyBsdf<float> {
    float pdfW(const Vec3f& wo, const Vec3f& wi) const {
        ShirleyBsdf lobe = *this;
        lobe.sampling = core::Weights{0, 0, 0, 1};
        return ShirleyBsdf::pdfW(wo, wi) + lobe.pdfW(wo, wi) * ((*sampling)[3] * 0.02f);
    }
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        BsdfSample<float> sample = ShirleyBsdf::sample(wo, u, n);
        const float right = sample.pdfW;
        sample.pdfW = pdfW(wo, sample.wi);
        sample.weight *= right / sample.pdfW;
        return sample;
    }
};

TEST(PlantedShirleyFault, APdfTwoPerCentTooLargeInOneLobeIsFound) {
    Faulty<Shirley, LargeLobe> faulty{brushed};
    faulty.sampling = core::Weights{0.5f, 0, 0, 0.5f};
    EXPECT_EQ(firstSampleFault(faulty, wo), "");
    const auto result = testSampling(faulty, wo);
    EXPECT_FALSE(result.accepted);
    EXPECT_FALSE(sumsToOne(result));
}

// Half vectors as if nu were nv.
struct SwappedSampler : ShirleyBsdf<float> {
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        ShirleyBsdf swapped = *this;
        swapped.halfVector = {halfVector.nv, halfVector.nu};
        BsdfSample<float> sample = swapped.sample(wo, u, n);
        sample.pdfW = ShirleyBsdf::pdfW(wo, sample.wi);
        sample.weight = ShirleyBsdf::eval(wo, sample.wi) / sample.pdfW;
        return sample;
    }
};

TEST(PlantedShirleyFault, ASamplerOfTheOtherAxisIsFound) {
    const Faulty<Shirley, SwappedSampler> faulty{onlyHighlight};
    EXPECT_FALSE(testSampling(faulty, wo).accepted);
    EXPECT_FALSE(albedoIsAccepted(faulty, wo));
}

// The exponents' mean for their mixture by the half vector's longitude.
struct MeanExponent : ShirleyBsdf<float> {
    Rgbf eval(const Vec3f& wo, const Vec3f& wi) const {
        ShirleyBsdf round = *this;
        const float mean = (halfVector.nu + halfVector.nv) / 2;
        round.halfVector = {mean, mean};
        return round.eval(wo, wi);
    }
};

TEST(PlantedShirleyFault, AWrongCombinationOfExponentsIsFound) {
    EXPECT_NE(firstPaperFault(Faulty<Shirley, MeanExponent>{brushed}), "");
    EXPECT_NE(firstSampleFault(Faulty<Shirley, MeanExponent>{brushed}, wo), "");
}

// The cosine of wo alone for the larger of both, which makes the model reciprocal.
struct OneCosine : ShirleyBsdf<float> {
    Rgbf eval(const Vec3f& wo, const Vec3f& wi) const {
        return ShirleyBsdf::eval(wo, wi) * (core::max(wo.z, wi.z) / wo.z);
    }
};

TEST(PlantedShirleyFault, ADenominatorThatIsNotReciprocalIsFound) {
    EXPECT_NE(firstReciprocityFault(Faulty<Shirley, OneCosine>{onlyHighlight}), "");
    EXPECT_NE(firstPaperFault(Faulty<Shirley, OneCosine>{onlyHighlight}), "");
}

// A cone of the perturbed reflection 2 % smaller than the one of the pdf.
struct NarrowCone : ShirleyBsdf<float> {
    BsdfSample<float> sample(const Vec3f& wo, const BsdfDraw<float>& u, const float& n) const {
        return ShirleyBsdf::sample(wo, BsdfDraw<float>{u.method, {u.place.x * 0.98f, u.place.y}}, n);
    }
};

TEST(PlantedShirleyFault, AConeTwoPerCentTooSmallIsFound) {
    Faulty<Shirley, NarrowCone> faulty{brushed};
    faulty.sampling = core::Weights{0, 1, 0, 0};
    EXPECT_FALSE(testSampling(faulty, wo).accepted);
}

}  // namespace
}  // namespace materials
