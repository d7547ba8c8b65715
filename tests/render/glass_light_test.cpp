// Lamps and glass: a lamp is counted once, by the path that meets it or, where a highlight stands for the lamp's mirror
// image, by light sampling.
// Seen to fail with lamps that are met counted although there is a highlight, and not counted although there is none
// or they are seen through the surface, a highlight with a cosine more, an exponent of 9, a half vector for the
// mirror's direction, a cone of other width, and shadow rays that glass does not stop.
#include "render/converges.h"
#include "render/each_integrator.h"
#include "render/optics.h"
#include "support/quadrature.h"

namespace render {
namespace {

using materials::Dielectric;

constexpr core::Rgbf radiance{7, 5, 3};
constexpr core::Rgbf highlight{0.9f, 0.4f, 0.1f};
constexpr core::Weights mirror{0, 1, 0, 0};

// A surface of glass, y = 0, that the eye sees at a slant in the origin. wo goes back to the eye.
struct Pond : TestScene {
    explicit Pond(const Dielectric& glass) {
        settings.globalIllumination = true;
        settings.pathLength = 3;
        addPolygon("surface", {{-3, 0, 4}, {5, 0, 4}, {5, 0, -3}, {-3, 0, -3}}, glass);
    }
    // Where the eye sees its mirror image.
    void addLampInTheMirror() { addAreaLight("lamp", radiance, {2, 2, 0}, 1); }

    testing::AssertionResult shows(const glm::dvec3& expected) const {
        return brings(Radiometer(*this, eye), ray, expected, 200);
    }

    static constexpr glm::dvec3 eye{-2, 2, 0};
    const glm::dvec3 wo = glm::normalize(eye);
    const core::Rayf ray = rayTowards(eye, {0, 0, 0});
    const double reflectance = fresnel(std::numbers::pi / 4, 1.5);
};

class LampInGlass : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, LampInGlass, eachIntegrator, integratorName);

TEST_P(LampInGlass, IsSeenOnceByTheMirror) {
    Pond pond({.sampling = mirror});
    pond.addLampInTheMirror();
    EXPECT_TRUE(pond.shows(pond.reflectance * glm::dvec3(radiance)));
}

TEST_P(LampInGlass, IsSeenOnceByABlurredMirror) {
    Pond pond({.sampling = mirror, .perturbation = 4});
    pond.addLampInTheMirror();  // it fills the cone
    EXPECT_TRUE(pond.shows(pond.reflectance * glm::dvec3(radiance)));
}

// The lamp's edge cuts through the cone: what is at the angle theta to its axis is beyond the edge for the turns phi
// with cos(phi) > tan(edge) / tan(theta).
TEST_P(LampInGlass, IsSeenInPartByABlurredMirror) {
    Pond pond({.sampling = mirror, .perturbation = 4});
    const double z = 0.1;
    pond.addAreaLight("lamp", radiance, {2, 2, z + 1}, 2);
    const double edge = std::asin(z / std::sqrt(2 * (z * z + 4))), least = std::cos(glm::radians(4.0));
    const auto beyond = [&](double cosine) {
        return std::acos(std::min(1.0, std::tan(edge) / std::tan(std::acos(cosine)))) / std::numbers::pi;
    };
    const double part = support::integrate(beyond, least, std::cos(edge), 1e-7) / (1 - least);
    EXPECT_TRUE(converges(Radiometer(pond, pond.eye), pond.ray, part * pond.reflectance * glm::dvec3(radiance)));
}

TEST_P(LampInGlass, IsSeenOnceThroughTheSurface) {
    for (const core::Rgbf& specular : {core::Rgbf(0), highlight}) {
        Pond pond({.specular = specular, .sampling = core::Weights{0, 0, 1, 0}});
        pond.addAreaLight("lamp", radiance, {0, -1, 0}, 4);
        pond.database.scale(":lamp", {0, -1, 0}, {1, -1, 1});
        EXPECT_TRUE(pond.shows((1 - pond.reflectance) / (1.5 * 1.5) * glm::dvec3(radiance)));
    }
}

// r (the mirror's direction of the light's) . k (to the eye).
double lobe(const glm::dvec3& wo, const glm::dvec3& toLight) {
    const glm::dvec3 wi = glm::normalize(toLight);
    const glm::dvec3 r = 2 * wi.y * glm::dvec3(0, 1, 0) - wi;
    return std::pow(std::max(0.0, glm::dot(r, wo)), 10);
}

class Highlight : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, Highlight, eachIntegrator, integratorName);

TEST_P(Highlight, OfAPointLightIsExact) {
    for (const glm::dvec3& lamp : {glm::dvec3(2, 2, 0), {2, 3, 0.5}, {1, 0.1, -1}, {-2, 1, 0.3}, {-0.2, 3, 0}}) {
        Pond pond({.specular = highlight});
        const glm::dvec3 intensity(7, 5, 3);
        pond.addPointLight("lamp", {lamp, intensity, {0.5, 0.2, 0.3}});
        const double distance = glm::length(lamp);
        const double falloff = 0.5 + 0.2 * distance + 0.3 * distance * distance;
        EXPECT_TRUE(pond.shows(glm::dvec3(highlight) * intensity * (std::numbers::pi * lobe(pond.wo, lamp) / falloff)));
    }
}

// The mirror meets the lamp in half of all paths and brings nothing; refracted paths leave into the dark.
TEST_P(Highlight, OfAnAreaLightIsAllThatIsSeenOfIt) {
    for (const double perturbation : {0.0, 4.0}) {
        Pond pond({.specular = highlight, .sampling = core::Weights{0, 0.5f, 0.5f, 0}, .perturbation = perturbation});
        pond.addLampInTheMirror();
        const auto arriving = [&](double x, double z) {
            const glm::dvec3 toLight(x, 2, z);
            const double distance2 = glm::dot(toLight, toLight);
            return lobe(pond.wo, toLight) * (2 / std::sqrt(distance2)) / distance2;
        };
        const double sum = support::integrate2d(arriving, 1.5, 2.5, -0.5, 0.5, 1e-7);
        EXPECT_TRUE(converges(Radiometer(pond, pond.eye), pond.ray, glm::dvec3(radiance) * glm::dvec3(highlight) * sum))
            << "perturbation " << perturbation;
    }
}

// What is not a lamp the mirror shows, with a highlight or without.
TEST_P(Highlight, LeavesTheMirrorImageOfTheSky) {
    Pond pond({.specular = highlight, .sampling = mirror});
    pond.settings.background = core::Rgbf(1, 2, 3);
    EXPECT_TRUE(pond.shows(pond.reflectance * glm::dvec3(1, 2, 3)));
}

TEST_P(Highlight, IsNotOnTheInside) {
    Pond pond({.specular = highlight});
    pond.addPointLight("lamp", {{2, -2, 0}, core::Rgbf(9), {1, 0, 0}});
    EXPECT_TRUE(pond.shows(glm::dvec3(0))) << "the light is beyond the surface";
}

class Glass : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, Glass, eachIntegrator, integratorName);

// Light through glass comes by paths alone.
TEST_P(Glass, CastsAShadow) {
    Pond pond({});
    pond.addPolygon("floor", {{-1, -1, 1}, {1, -1, 1}, {1, -1, -1}, {-1, -1, -1}}, core::Rgbf(0.5f));
    pond.addPointLight("lamp", {{0, 3, 0}, core::Rgbf(9), {1, 0, 0}});
    const glm::dvec3 under(0, -0.5, 0);
    const Radiometer radiometer(pond, under);
    for (int path = 0; path < 50; ++path)
        ASSERT_EQ(radiometer.sample(rayTowards(under, {0.1, -1, 0.2}), 1, path), core::Rgbf(0));
}

}  // namespace
}  // namespace render
