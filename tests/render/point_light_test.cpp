// Light without noise: what points of light, the ambient and the background give is known to single precision.
#include "render/converges.h"
#include "render/each_integrator.h"

#include <gmock/gmock.h>

namespace render {
namespace {

constexpr core::Rgbf reflectance{0.8f, 0.5f, 0.3f};
constexpr glm::dvec3 intensity{7, 5, 3};

// A floor in y = 0 and a camera that looks at a point of it. Not a square: the edge between its two triangles runs
// past the points looked at, for near an edge a hit is put back from it by more than these tests allow.
struct Floor : TestScene {
    Floor() { addPolygon("floor", {{-9, 0, -9.5}, {9.25, 0, -9}, {9, 0, 9.25}, {-9.5, 0, 9}}, reflectance); }

    core::Rgbf radianceAt(const glm::dvec3& point, const glm::dvec3& from = {4, 3, -2}) const {
        return Radiometer(*this).sample(rayTowards(from, point), 1, 0);
    }
};

// R_d / pi of the irradiance pi * I * cos / (c0 + c1 d + c2 d^2).
glm::dvec3 shown(const glm::dvec3& light, const glm::dvec3& point, const glm::dvec3& attenuation) {
    const double distance = glm::distance(light, point);
    const double cosine = (light.y - point.y) / distance;
    return intensity * glm::dvec3(reflectance) * cosine /
           (attenuation.x + attenuation.y * distance + attenuation.z * distance * distance);
}

class PointLight : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, PointLight, eachIntegrator, integratorName);

TEST_P(PointLight, FallsOffAsItsAttenuationSays) {
    const glm::dvec3 position(1, 2, -1.5);
    const glm::dvec3 attenuations[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.3, 0.2, 0.1}};
    const glm::dvec3 points[] = {{1, 0, -1.5}, {0, 0, 0}, {-3, 0, 4}, {8.5, 0, -8.5}};
    for (const glm::dvec3& attenuation : attenuations) {
        Floor scene;
        scene.addPointLight("lamp", {position, intensity, attenuation});
        for (const glm::dvec3& point : points)
            EXPECT_TRUE(isNear(scene.radianceAt(point), shown(position, point, attenuation)))
                << "attenuation " << attenuation.x << " " << attenuation.y << " " << attenuation.z << ", point "
                << point.x << " " << point.z;
    }
}

TEST_P(PointLight, LooksTheSameFromEverywhere) {
    Floor scene;
    scene.addPointLight("lamp", {{1, 2, 3}, intensity, {0, 0, 1}});
    for (const glm::dvec3& eye : {glm::dvec3(0, 9, 0), {8, 0.1, 8}, {-3, 1, 0.5}})
        EXPECT_TRUE(isNear(scene.radianceAt({1, 0, 1}, eye), shown({1, 2, 3}, {1, 0, 1}, {0, 0, 1})));
}

TEST_P(PointLight, AddsToOthersAndShinesOnlyWhenNamed) {
    Floor scene;
    scene.addPointLight("left", {{-2, 2, 0}, intensity, {0, 0, 1}});
    scene.addPointLight("right", {{2, 1, 0}, intensity, {1, 0, 0}});
    const glm::dvec3 left = shown({-2, 2, 0}, {0, 0, 0}, {0, 0, 1});
    EXPECT_TRUE(isNear(scene.radianceAt({0, 0, 0}), left + shown({2, 1, 0}, {0, 0, 0}, {1, 0, 0})));
    scene.pointLights = {"left"};
    EXPECT_TRUE(isNear(scene.radianceAt({0, 0, 0}), left));
    scene.pointLights = {};
    EXPECT_EQ(scene.radianceAt({0, 0, 0}), core::Rgbf(0));
}

// A surface is lit and seen on the same side, or it is dark. Which way its polygon is wound does not matter.
TEST_P(PointLight, ShinesOnTheSideThatIsSeen) {
    for (const bool isTurned : {false, true}) {
        TestScene scene;
        std::vector<glm::dvec3> outline{{-9, 0, -9.5}, {9.25, 0, -9}, {9, 0, 9.25}, {-9.5, 0, 9}};
        if (isTurned) std::reverse(outline.begin(), outline.end());
        scene.addPolygon("floor", outline, reflectance);
        scene.addPointLight("lamp", {{1, 2, 3}, intensity, {0, 0, 1}});
        const Radiometer radiometer(scene);
        EXPECT_TRUE(
            isNear(radiometer.sample(rayTowards({4, 3, -2}, {0, 0, 0}), 1, 0), shown({1, 2, 3}, {0, 0, 0}, {0, 0, 1})));
        EXPECT_EQ(radiometer.sample(rayTowards({4, -3, -2}, {0, 0, 0}), 1, 0), core::Rgbf(0));
    }
}

// A ball at height 1 under a light at height 2: its shadow is a disc, whose edge the tangent cone draws.
TEST_P(PointLight, CastsASharpShadow) {
    Floor scene;
    scene.addPointLight("lamp", {{0, 2, 0}, intensity, {0, 0, 1}});
    scene.add("ball", gr::SphereNode{{0, 1, 0}, 0.5}, reflectance);
    const double shadow = 2 * std::tan(std::asin(0.5));
    for (int i = 0; i < 17; ++i) {
        const double angle = 0.37 * i;
        const glm::dvec3 outward(std::cos(angle), 0, std::sin(angle));
        const glm::dvec3 lit = outward * (shadow * 1.0001);
        const glm::dvec3 eye = outward * 6.0 + glm::dvec3(0, 1, 0);
        EXPECT_EQ(scene.radianceAt(outward * (shadow * 0.9999), eye), core::Rgbf(0));
        EXPECT_TRUE(isNear(scene.radianceAt(lit, eye), shown({0, 2, 0}, lit, {0, 0, 1})));
    }
}

TEST_P(PointLight, IsNotHiddenByWhatIsBehindIt) {
    Floor scene;
    scene.addPointLight("lamp", {{0, 2, 0}, intensity, {0, 0, 1}});
    scene.add("ceiling", gr::BoxNode{{-9, 2.01, -9}, {18, 1, 18}}, reflectance);
    EXPECT_TRUE(isNear(scene.radianceAt({1, 0, 1}, {4, 1, -2}), shown({0, 2, 0}, {1, 0, 1}, {0, 0, 1})));
}

// At the light itself there is no direction to it. Nothing may come of that but a number.
TEST_P(PointLight, IsFiniteOnASurface) {
    TestScene scene;
    scene.add("ball", gr::SphereNode{}, reflectance);
    scene.addPointLight("lamp", {{0, 1, 0}, intensity, {0, 0, 1}});
    const Radiometer radiometer(scene);
    for (const double off : {0.0, 1e-30, 1e-7, 1e-3})
        EXPECT_TRUE(core::isFinite(radiometer.sample(rayTowards({off, 5, 0}, {off, 0, 0}), 1, 0))) << off;
}

class AmbientLight : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, AmbientLight, eachIntegrator, integratorName);

TEST_P(AmbientLight, IsAddedToEverySurfaceWithoutGlobalIllumination) {
    Floor scene;
    scene.ambient = core::Rgbf(0.1f, 0.2f, 0.4f);
    scene.settings.background = core::Rgbf(5);
    const glm::dvec3 ambient = glm::dvec3(reflectance) * glm::dvec3(scene.ambient);
    EXPECT_TRUE(isNear(scene.radianceAt({0, 0, 0}), ambient));
    scene.addPointLight("lamp", {{1, 2, 3}, intensity, {0, 0, 1}});
    EXPECT_TRUE(isNear(scene.radianceAt({0, 0, 0}), ambient + shown({1, 2, 3}, {0, 0, 0}, {0, 0, 1})));
    EXPECT_TRUE(isNear(scene.radianceAt({0, 0, 0}, {4, -3, 0}), ambient)) << "from below";
}

// A path that leaves the scene, or ends at a light, has not been cut short: it gets no ambient light.
TEST_P(AmbientLight, IsNotAddedToAPathThatEndsBefore) {
    Floor scene;
    scene.ambient = core::Rgbf(1);
    scene.settings.globalIllumination = true;
    const Radiometer open(scene);
    for (int i = 0; i < 1'000; ++i) ASSERT_EQ(open.sample(rayTowards({4, 3, -2}, {0, 0, 0}), 1, i), core::Rgbf(0));
    EXPECT_EQ(open.sample(rayTowards({4, 3, -2}, {4, 9, 0}), 1, 0), core::Rgbf(0));
    scene.addAreaLight("lamp", core::Rgbf(2, 3, 4), {0, 2, 0}, 1);
    EXPECT_EQ(Radiometer(scene).sample(rayTowards({0, 1, 0}, {0, 2, 0}), 1, 0), core::Rgbf(2, 3, 4));
}

class Background : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, Background, eachIntegrator, integratorName);

TEST_P(Background, IsSeenWhereNothingElseIs) {
    Floor scene;
    scene.settings.background = core::Rgbf(0.5f, 0.25f, 2);
    for (const bool everything : {false, true}) {
        scene.settings.globalIllumination = everything;
        EXPECT_EQ(Radiometer(scene).sample(rayTowards({0, 1, 0}, {1, 2, 3}), 1, 0), scene.settings.background);
    }
    scene.settings.globalIllumination = false;
    EXPECT_EQ(scene.radianceAt({0, 0, 0}), core::Rgbf(0)) << "direct light does not come from there";
}

}  // namespace
}  // namespace render
