// planted_shirley_fault_test.cpp sees firstPaperFault and the tests of mean weights fail.
#include "materials/shirley.h"

#include <gtest/gtest.h>

#include "materials/albedo.h"
#include "materials/parameter_sets.h"
#include "materials/shirley_paper.h"

namespace materials {
namespace {

using core::Rgbf;
using core::Vec3f;

// The paper's f * cos over the hemisphere, the mean of the channels.
double paperAlbedo(const Shirley& material, const Vec3f& wo) {
    const auto reflected = [&](const Vec3f& wi) {
        const glm::dvec3 f = paperF(material, wo, wi);
        return wi.z > 0 ? (f.x + f.y + f.z) / 3 * wi.z : 0;
    };
    return withMap(material, wo, [&](const auto& map) { return integrateOver(map, reflected); });
}

TEST(Shirley, IsThePapers) {
    for (const Shirley& material : parameterSets<Shirley>()) EXPECT_EQ(firstPaperFault(material), "");
}

TEST(Shirley, HasThePapersAlbedo) {
    for (const Shirley& material : parameterSets<Shirley>())
        for (const Vec3f& wo : outgoingDirections())
            EXPECT_NEAR(albedo(material, wo, mean), paperAlbedo(material, wo), 5e-5) << "wo " << text(wo);
}

// Along the normal the base fades by 1/32, and a highlight as narrow as this by next to nothing.
TEST(Shirley, HasTheAlbedoThatItReflectsAlongTheNormal) {
    const Rgbf colours[] = {{0.9f, 0.4f, 0.1f}, {0.2f, 0.6f, 0}, {0, 0, 0}, {1, 1, 1}};
    for (const Rgbf& base : colours) {
        for (const Rgbf& highlight : colours) {
            const Shirley material{.diffuse = base, .specular = highlight, .exponents = {10'000, 10'000}};
            for (int channel = 0; channel < 3; ++channel) {
                const auto value = [&](const Rgbf& c) { return c[channel]; };
                const double faded = base[channel] * (1 - highlight[channel]) / 32;
                EXPECT_NEAR(albedo(material, {0, 0, 1}, value) + faded, material.albedo<float>(SomePoint{})[channel],
                            5e-4);
            }
        }
    }
}

// All mixtures in which some method goes everywhere.
TEST(Shirley, HasOneMeanWeightWhateverTheMixture) {
    const std::optional<core::Weights> mixtures[] = {std::nullopt,
                                                     core::Weights{1, 0, 0, 0},
                                                     core::Weights{0, 0, 0, 1},
                                                     core::Weights{0.5f, 0, 0, 0.5f},
                                                     core::Weights{0.3f, 0.7f, 0, 0},
                                                     core::Weights{0, 0.5f, 0, 0.5f},
                                                     core::Weights{0.1f, 0.2f, 0.3f, 0.4f}};
    Shirley material{.diffuse = Rgbf(0.9f, 0.5f, 0.1f), .specular = Rgbf(0.2f), .exponents = {2, 5}};
    for (const Vec3f& wo : {Vec3f(0, 0, 1), Vec3f(0.48f, 0.64f, 0.6f)}) {
        const double expected = paperAlbedo(material, wo);
        for (const auto& mixture : mixtures) {
            material.sampling = mixture;
            const support::TestResult result = support::zTest(sampledWeight(material, wo), expected);
            EXPECT_TRUE(result.accepted) << (mixture ? core::optionText(mixture) : "default") << ": " << result.text;
        }
    }
}

// With nu >> nv the highlight is narrow along x, the u axis, and wide along y.
TEST(Shirley, IsNarrowAlongTheAxisOfTheLargerExponent) {
    const Shirley brushed{.diffuse = Rgbf(0), .specular = Rgbf(1), .exponents = {10000, 10}};
    const Vec3f wo(0, 0, 1), alongX(0.1f, 0, std::sqrt(0.99f)), alongY(0, 0.1f, std::sqrt(0.99f));
    EXPECT_GT(bsdfOf(brushed).eval(wo, alongY).x, 1e5f * bsdfOf(brushed).eval(wo, alongX).x);
    support::TestRandom random(8);
    support::RunningMean x2, y2;
    for (int i = 0; i < 10'000; ++i) {
        const BsdfSample<float> sample = draw(brushed, wo, random);
        if (!sample.valid) continue;
        x2.add(sample.wi.x * sample.wi.x);
        y2.add(sample.wi.y * sample.wi.y);
    }
    EXPECT_GT(y2.mean(), 100 * x2.mean());
}

bool isSound(const Rgbf& c) {
    return core::isFinite(c) && c.x >= 0 && c.y >= 0 && c.z >= 0;
}

// Directions close to the horizon, the normal, each other and each other's mirror image.
std::vector<Vec3f> extremeDirections() {
    std::vector<Vec3f> directions{{0, 0, 1}};
    for (const double z : {1e-30, 1e-10, 1e-7, 1e-6, 1e-4, 0.01, 0.5, 1 - 1e-4, 1 - 1e-7})
        for (const double phi : {0.0, 0.7, 0.5 * std::numbers::pi, std::numbers::pi, 0.7 + std::numbers::pi, 5.0}) {
            const double sine = std::sqrt(1 - z * z);
            directions.emplace_back(sine * std::cos(phi), sine * std::sin(phi), z);
        }
    return directions;
}

TEST(Shirley, IsFiniteAtTheExtremes) {
    const core::Vec2f exponents[] = {{0, 0}, {1e6f, 1e6f}, {0, 1e6f}, {1e6f, 3}};
    const float numbers[] = {0, 0x1p-24f, 0.3f, 0.5f, 1 - 0x1p-24f};
    for (const core::Vec2f& exponent : exponents) {
        for (const Rgbf& colour : {Rgbf(0), Rgbf(0.5f), Rgbf(1)}) {
            Shirley material{.diffuse = colour, .specular = colour, .exponents = exponent};
            for (const Vec3f& wo : extremeDirections()) {
                for (const Vec3f& wi : extremeDirections()) {
                    EXPECT_TRUE(isSound(bsdfOf(material).eval(wo, wi))) << text(wo) << text(wi);
                    const float pdf = bsdfOf(material).pdfW(wo, wi);
                    EXPECT_TRUE(std::isfinite(pdf) && pdf >= 0) << text(wo) << text(wi) << " " << pdf;
                }
                for (const auto& sampling :
                     {std::optional<core::Weights>(), std::optional(core::Weights{1, 0, 0, 0}),
                      std::optional(core::Weights{0, 1, 0, 0}), std::optional(core::Weights{0, 0, 0, 1})}) {
                    material.sampling = sampling;
                    for (const float method : numbers)
                        for (const float u : numbers)
                            for (const float v : numbers) {
                                const auto sample = bsdfOf(material).sample(wo, BsdfDraw<float>{method, {u, v}}, 1.f);
                                EXPECT_TRUE(!sample.valid || (isSound(sample.weight) && std::isfinite(sample.pdfW)))
                                    << "wo " << text(wo) << " wi " << text(sample.wi) << " " << text(sample.weight);
                            }
                }
                material.sampling.reset();
            }
        }
    }
}

// Black reflects nothing, and still gives samples of no weight.
TEST(Shirley, MayBeBlack) {
    const Shirley black{.diffuse = Rgbf(0), .specular = Rgbf(0)};
    const Vec3f wo(0.6f, 0, 0.8f);
    EXPECT_EQ(bsdfOf(black).eval(Vec3f(0, 0, 1), Vec3f(0, 0, 1)), Rgbf(0));
    EXPECT_EQ(firstSampleFault(black, wo), "");
}

TEST(Shirley, IsLitWhateverTheMethod) {
    const Shirley mixed{.sampling = core::Weights{0.25f, 0.5f, 0, 0.25f}};
    const Vec3f wo(0.6f, 0, 0.8f);
    for (const float method : {0.1f, 0.5f, 0.9f}) {
        const BsdfSample<float> sample = bsdfOf(mixed).sample(wo, BsdfDraw<float>{method, {0.5f, 0.5f}}, 1.f);
        EXPECT_TRUE(sample.valid && sample.isLit && !sample.isDelta) << method;
        EXPECT_EQ(sample.isDiffuse, method < 0.25f) << method;
    }
}

// Tux's beak, a green of the course's, what leaves no room, and what leaves all.
const Shirley kept[] = {
    {.diffuse = {0.88f, 0.67f, 0.15f}, .specular = {0.99f, 0.94f, 0.81f}, .exponents = {28, 28}, .keepDiffuse = true},
    {.diffuse = {0.7f, 1, 0.7f}, .specular = {0.5f, 0.7f, 0.5f}, .exponents = {25, 25}, .keepDiffuse = true},
    {.diffuse = Rgbf(1), .specular = Rgbf(1), .exponents = {0, 0}, .keepDiffuse = true},
    {.diffuse = {1, 0, 0}, .specular = {0, 0, 1}, .exponents = {5, 50}, .keepDiffuse = true},
    {.diffuse = {1, 0.5f, 0}, .specular = Rgbf(0.01f), .exponents = {9, 9}, .keepDiffuse = true},
    {.diffuse = {0.5f, 0.2f, 0.1f}, .specular = {0.3f, 0.2f, 0.1f}, .exponents = {10, 300}, .keepDiffuse = true},
    {.diffuse = Rgbf(0), .specular = Rgbf(1), .exponents = {10, 10}, .keepDiffuse = true}};

TEST(Shirley, KeptDiffuseIsSeenAsItIsButForAVarnish) {
    for (const Shirley& material : kept) {
        const float brightest = core::largestComponent(material.diffuse.value);
        const float room = std::min(0.04f, core::largestComponent(material.specular.value));
        const Rgbf seen = material.diffuse.value * std::min(1.f, brightest > 0 ? (1 - room) / brightest : 1.f);
        const ShirleyBsdf<float> bsdf = bsdfOf(material);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(bsdf.diffuse[channel] * (1 - bsdf.specular[channel]), seen[channel], 1e-6f);
        EXPECT_EQ(material.ambientReflectance<float>(SomePoint{}), material.diffuse.value);
    }
}

// The channel in which least is left has all of it, unless R_s asks for less.
TEST(Shirley, KeptDiffuseLeavesTheHighlightItsHueAndWhatThereIsLeft) {
    for (const Shirley& material : kept) {
        const ShirleyBsdf<float> bsdf = bsdfOf(material);
        const float part = core::largestComponent(bsdf.specular) / core::largestComponent(material.specular.value);
        float fullest = 0;
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(bsdf.specular[channel], part * material.specular.value[channel], 1e-6f);
            const float both = bsdf.specular[channel] + bsdf.diffuse[channel] * (1 - bsdf.specular[channel]);
            EXPECT_LE(both, 1 + 1e-6f);
            EXPECT_NEAR(both, material.albedo<float>(SomePoint{})[channel], 1e-6f);
            if (material.specular.value[channel] > 0) fullest = std::max(fullest, both);
        }
        EXPECT_TRUE(std::abs(part - 1) < 1e-6f || std::abs(fullest - 1) < 1e-6f) << part << " " << fullest;
    }
}

TEST(Shirley, KeptDiffuseReflectsNoMoreThanArrives) {
    for (const Shirley& material : kept)
        for (const Vec3f& wo : outgoingDirections())
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_LE(albedo(material, wo, [&](const Rgbf& c) { return c[channel]; }), 1 + 1e-4);
}

TEST(Shirley, ReflectsAmbientLightByItsBase) {
    const Shirley material{.diffuse = Rgbf(0.9f, 0.5f, 0.1f)};
    EXPECT_EQ(material.ambientReflectance<float>(SomePoint{}), material.diffuse.value);
    EXPECT_FALSE(material.isAnisotropic());
    EXPECT_TRUE(Shirley({.exponents = {10, 11}}).isAnisotropic());
}

}  // namespace
}  // namespace materials
