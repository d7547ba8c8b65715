// Beer's law: e^(-a t) of the light is left after a way t inside, in a medium that bends no light (index 1).
// Seen to fail with powers of 10 for those of e, an absorption 2 % too large, no absorption on shadow rays, on the way
// to the sky or on that between surfaces, and an eye that is taken to be outside.
#include "render/converges.h"
#include "render/each_integrator.h"
#include "render/optics.h"
#include "support/quadrature.h"

namespace render {
namespace {

using materials::Dielectric;

constexpr double pi = std::numbers::pi;
constexpr core::Rgbf sky{5, 3, 2};
constexpr core::Rgbf reflectance{0.8f, 0.5f, 0.3f};
constexpr glm::dvec3 absorption{0.05, 0.7, 2.3};

struct Murk : TestScene {
    Murk() {
        settings.globalIllumination = true;
        settings.background = sky;
        settings.pathLength = 10;
    }
};

Dielectric murky(const glm::dvec3& a) {
    return {.index = 1, .absorption = core::Rgbf(a)};
}

glm::dvec3 left(const glm::dvec3& a, double length) {
    return glm::exp(-a * length);
}

// Paths start a hair off a surface, which shortens the way in the medium by up to 10^-5 of the scene.
testing::AssertionResult isLeft(const core::Rgbf& radiance, const glm::dvec3& expected) {
    for (int channel = 0; channel < 3; ++channel)
        if (!(std::abs(radiance[channel] - expected[channel]) <= 5e-4 * expected[channel]))
            return testing::AssertionFailure()
                   << "channel " << channel << ": " << radiance[channel] << ", expected " << expected[channel];
    return testing::AssertionSuccess();
}

class Absorption : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, Absorption, eachIntegrator, integratorName);

// The slab is 0 <= y <= thickness: rays from above go down at a slant.
TEST_P(Absorption, OfASlabSeenFromOutsideFollowsBeersLaw) {
    for (const double thickness : {0.01, 0.3, 1.0, 4.0}) {
        for (const glm::dvec3& a : {absorption, glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0.2)}) {
            Murk scene;
            scene.add("slab", gr::BoxNode{{-10, 0, -10}, {20, thickness, 20}}, murky(a));
            for (const double angle : {0.0, 0.4, 1.1}) {
                const glm::dvec3 eye(0.1, thickness + 1, -0.3);
                const core::Rayf ray = rayTowards(eye, eye + glm::dvec3(std::sin(angle), -std::cos(angle), 0));
                EXPECT_TRUE(isLeft(Radiometer(scene, eye).sample(ray, 1, 0),
                                   glm::dvec3(sky) * left(a, thickness / std::cos(angle))))
                    << "thickness " << thickness << ", angle " << angle;
            }
        }
    }
}

TEST_P(Absorption, OfASlabSeenFromInsideBeginsAtTheEye) {
    Murk scene;
    scene.add("slab", gr::BoxNode{{-10, 0, -10}, {20, 2, 20}}, murky(absorption));
    const glm::dvec3 eye(0.1, 0.7, -0.3);
    const Radiometer radiometer(scene, eye);
    EXPECT_TRUE(
        isLeft(radiometer.sample(rayTowards(eye, {0.1, 0, -0.3}), 1, 0), glm::dvec3(sky) * left(absorption, 0.7)));
    EXPECT_TRUE(isLeft(radiometer.sample(rayTowards(eye, {1.4, 2, -0.3}), 1, 0),
                       glm::dvec3(sky) * left(absorption, 1.3 * std::numbers::sqrt2)));
}

// Each of two balls, one in the other, absorbs on the part of the way that is in it and not in the other.
TEST_P(Absorption, OfABallInABallIsThatOfTheInner) {
    Murk scene;
    const glm::dvec3 inner(0.2, 0.9, 0.4), eye(0, 0, 0.5);
    scene.add("outer", gr::SphereNode{{0, 0, 0}, 3}, murky(absorption));
    scene.add("inner", gr::SphereNode{{0, 0, 0}, 1}, murky(inner));
    const Radiometer inside(scene, eye);
    EXPECT_TRUE(isLeft(inside.sample(rayTowards(eye, {0, 0, 2}), 1, 0),
                       glm::dvec3(sky) * left(inner, 0.5) * left(absorption, 2)));
    EXPECT_TRUE(isLeft(inside.sample(rayTowards(eye, {0, 0, -2}), 1, 0),
                       glm::dvec3(sky) * left(inner, 1.5) * left(absorption, 2)));
    const Radiometer between(scene, {0, 0, 2});
    EXPECT_TRUE(isLeft(between.sample(rayTowards({0, 0, 2}, {0, 0, 0}), 1, 0),
                       glm::dvec3(sky) * left(inner, 2) * left(absorption, 3)));
    const Radiometer outside(scene, {0, 0, 7});
    EXPECT_TRUE(isLeft(outside.sample(rayTowards({0, 0, 7}, {0, 0, 0}), 1, 0),
                       glm::dvec3(sky) * left(inner, 2) * left(absorption, 4)));
}

// A floor, a light and the eye in a tank.
struct Tank : Murk {
    Tank() {
        settings.background = core::Rgbf(0);
        settings.globalIllumination = false;
        add("tank", gr::BoxNode{{-10, -10, -10}, {20, 20, 20}}, murky(absorption));
        addPolygon("floor", {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}}, reflectance);
    }
    glm::dvec3 eye{0.6, 0.4, 0.2};
    glm::dvec3 fromEye = left(absorption, glm::length(eye));
};

TEST_P(Absorption, ReachesTheWayFromAPointLight) {
    Tank tank;
    const glm::dvec3 lamp(-0.3, 1.2, 0.5), intensity(7, 5, 3);
    tank.addPointLight("lamp", {lamp, intensity, {0, 0, 1}});
    const double distance = glm::length(lamp);
    const glm::dvec3 expected = intensity * glm::dvec3(reflectance) * (lamp.y / distance / (distance * distance)) *
                                left(absorption, distance) * tank.fromEye;
    EXPECT_TRUE(isLeft(Radiometer(tank, tank.eye).sample(rayTowards(tank.eye, {0, 0, 0}), 1, 0), expected));
}

TEST_P(Absorption, ReachesTheWayFromAnAreaLight) {
    Tank tank;
    const core::Rgbf radiance(7, 5, 3);
    tank.addAreaLight("lamp", radiance, {0.5, 1, 0}, 1.5);
    glm::dvec3 expected;
    for (int channel = 0; channel < 3; ++channel) {
        const auto arriving = [&](double x, double z) {
            const double distance2 = x * x + 1 + z * z;
            return std::exp(-absorption[channel] * std::sqrt(distance2)) / (distance2 * distance2);
        };
        expected[channel] = radiance[channel] * reflectance[channel] / pi * tank.fromEye[channel] *
                            support::integrate2d(arriving, -0.25, 1.25, -0.75, 0.75, 1e-7);
    }
    const Radiometer radiometer(tank, tank.eye);
    EXPECT_TRUE(converges(radiometer, rayTowards(tank.eye, {0, 0, 0}), expected));
    // And the way from the light itself.
    const glm::dvec3 place(0.6, 1, 0.2);
    EXPECT_TRUE(
        isLeft(radiometer.sample(rayTowards(tank.eye, place), 1, 0), glm::dvec3(radiance) * left(absorption, 0.6)));
}

// A speck in the middle of a ball sees the sky through its radius, all round.
TEST_P(Absorption, ReachesTheWayOfABounce) {
    Murk scene;
    scene.add("ball", gr::SphereNode{{0, 0, 0}, 2}, murky(absorption));
    scene.addPolygon("speck", {{-0.001, 0, 0.001}, {0.001, 0, 0.001}, {0, 0, -0.001}}, core::Rgbf(0.8f));
    const glm::dvec3 eye(0.3, 0.4, 0);
    EXPECT_TRUE(
        converges(Radiometer(scene, eye), rayTowards(eye, {0, 0, 0}), 0.8 * glm::dvec3(sky) * left(absorption, 2.5)));
}

// Glass reflects R at each surface: the light goes to and fro in it, R e^(-a t) being left each time.
TEST_P(Absorption, OfASlabOfGlassAddsUpOverItsReflections) {
    Murk scene;
    scene.settings.pathLength = 50;
    const double n = 2, thickness = 0.4, r = normalReflectance(n);
    scene.add("slab", gr::BoxNode{{-10, 0, -10}, {20, thickness, 20}},
              Dielectric{.index = n, .absorption = core::Rgbf(absorption)});
    const glm::dvec3 once = left(absorption, thickness);
    const glm::dvec3 expected = glm::dvec3(sky) * (r + (1 - r) * (1 - r) * once / (1.0 - r * once));
    EXPECT_TRUE(converges(Radiometer(scene, {0, 2, 0}), rayTowards({0, 2, 0}, {0, 0, 0}), expected));
}

// The way to the sky is endless.
TEST_P(Absorption, LeavesNothingOfTheSkyInAMediumWithoutEnd) {
    Murk scene;
    scene.addPolygon("surface", {{-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}}, murky({0, 1e-6, 0}));
    for (int path = 0; path < 100; ++path)
        ASSERT_EQ(Radiometer(scene, {0, 1, 0}).sample(rayTowards({0, 1, 0}, {0.2, 0, 0.1}), 1, path),
                  core::Rgbf(sky.x, 0, sky.z));
}

}  // namespace
}  // namespace render
