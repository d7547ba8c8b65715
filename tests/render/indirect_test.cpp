// Light that comes by way of a wall, against quadrature of the same integral:
// L = R_d/pi * integral over the wall of (R_w/pi * E(y)) cos cos' / d^2 dy, with E(y) by Lambert's formula.
// Seen to fail with a light's emission counted again after a bounce, the bounce's cosine dropped, its density doubled,
// and a path one point too short.
#include "render/converges.h"
#include "render/each_integrator.h"
#include "render/lambert.h"
#include "support/quadrature.h"

#include <glm/ext/scalar_constants.hpp>

namespace render {
namespace {

constexpr double pi = glm::pi<double>();
constexpr core::Rgbf floorReflectance{0.8f, 0.5f, 0.3f};
constexpr core::Rgbf wallReflectance{0.4f, 0.9f, 0.6f};
constexpr glm::dvec3 radiance{7, 5, 3};
constexpr glm::dvec3 point{0, 0, 0};
constexpr glm::dvec3 up{0, 1, 0};
constexpr glm::dvec3 fromWall{-1, 0, 0};

// A speck of floor, so small that the wall is lit by the lamp alone, and a wall in the plane x = 1.
struct FloorAndWall : TestScene {
    explicit FloorAndWall(double wallHeight) : height(wallHeight) {
        addPolygon("floor", {{-0.01, 0, -0.01}, {0.01, 0, -0.01}, {0.01, 0, 0.01}, {-0.01, 0, 0.01}}, floorReflectance);
        addPolygon("wall", {{1, 0, -2}, {1, height, -2}, {1, height, 2}, {1, 0, 2}}, wallReflectance);
        settings.globalIllumination = true;
    }

    core::Rayf ray() const { return rayTowards({-0.1, 0.1, 0.05}, point); }

    // What the floor shows of the wall, by the irradiance at the wall's points.
    glm::dvec3 shownOfWall(const std::function<double(const glm::dvec3&)>& irradiance) const {
        const auto arriving = [&](double y, double z) {
            const glm::dvec3 toWall = glm::dvec3(1, y, z) - point;
            const double distance = glm::length(toWall);
            const double cosines = toWall.y * toWall.x / (distance * distance);
            return irradiance({1, y, z}) / pi * cosines / (distance * distance);
        };
        const double sum = support::integrate2d(arriving, 0, height, -2, 2, 1e-6);
        return glm::dvec3(floorReflectance) * glm::dvec3(wallReflectance) * (sum / pi);
    }

    double height;
};

class IndirectLight : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, IndirectLight, eachIntegrator, integratorName);

TEST_P(IndirectLight, OfAnAreaLightComesFromTheWallAlone) {
    FloorAndWall scene(3);
    // The lamp turns its back to the floor.
    scene.addAreaLight("lamp", core::Rgbf(radiance), {0, 0, 0}, 0.8);
    scene.database.translate(":lamp", {0.02, 0.7, 0});
    scene.database.rotate(":lamp", 2, 90);
    const Polygon lamp{{0.02, 0.3, -0.4}, {0.02, 1.1, -0.4}, {0.02, 1.1, 0.4}, {0.02, 0.3, 0.4}};
    const glm::dvec3 expected =
        radiance * scene.shownOfWall([&](const glm::dvec3& y) { return lambertIrradiance(lamp, y, fromWall); });
    EXPECT_TRUE(converges(Radiometer(scene), scene.ray(), expected));
}

// Half of the floor's sky is wall, a good part of the rest is lamp: the lamp must not be counted when a bounce meets
// it.
TEST_P(IndirectLight, OfAnAreaLightAddsToItsDirectLight) {
    FloorAndWall scene(2);
    scene.addAreaLight("lamp", core::Rgbf(radiance), {-0.4, 2, 0}, 2.4);
    const Polygon lamp{{-1.6, 2, -1.2}, {0.8, 2, -1.2}, {0.8, 2, 1.2}, {-1.6, 2, 1.2}};
    const glm::dvec3 direct = radiance * glm::dvec3(floorReflectance) * lambertIrradiance(lamp, point, up) / pi;
    const glm::dvec3 indirect =
        radiance * scene.shownOfWall([&](const glm::dvec3& y) { return lambertIrradiance(lamp, y, fromWall); });
    EXPECT_GT(indirect.x, 0.05 * direct.x) << "or the test would show little";
    EXPECT_TRUE(converges(Radiometer(scene), scene.ray(), direct + indirect));
    scene.settings.globalIllumination = false;
    EXPECT_TRUE(converges(Radiometer(scene), scene.ray(), direct));
}

TEST_P(IndirectLight, OfAPointLightAddsToItsDirectLight) {
    FloorAndWall scene(2.5);
    const glm::dvec3 lamp(0.3, 1.2, -0.4), attenuation(0.5, 0.2, 0.3);
    scene.addPointLight("lamp", {lamp, radiance, attenuation});
    const auto irradiance = [&](const glm::dvec3& y, const glm::dvec3& normal) {
        const double distance = glm::distance(lamp, y);
        const double cosine = glm::dot(lamp - y, normal) / distance;
        return pi * cosine / glm::dot(attenuation, glm::dvec3(1, distance, distance * distance));
    };
    const glm::dvec3 direct = radiance * glm::dvec3(floorReflectance) * irradiance(point, up) / pi;
    const glm::dvec3 indirect =
        radiance * scene.shownOfWall([&](const glm::dvec3& y) { return irradiance(y, fromWall); });
    EXPECT_TRUE(converges(Radiometer(scene), scene.ray(), direct + indirect));
}

// The background comes in over the wall, whose own part is dark: what is left is the open part of the sky, as bright as
// a polygon of that radiance would be, and what the wall has of the sky itself.
TEST_P(IndirectLight, OfTheBackgroundIsWhatTheWallLeavesOpen) {
    FloorAndWall scene(3);
    scene.settings.background = core::Rgbf(radiance);
    const Polygon wall{{1, 0, -2}, {1, 3, -2}, {1, 3, 2}, {1, 0, 2}};
    const glm::dvec3 open = radiance * glm::dvec3(floorReflectance) * (1 - lambertIrradiance(wall, point, up) / pi);
    EXPECT_TRUE(converges(Radiometer(scene), scene.ray(), open)) << "pathlength 2: a wall without light";
    // The wall sees nothing but sky: E = pi.
    scene.settings.pathLength = 3;
    const glm::dvec3 byTheWall = radiance * scene.shownOfWall([](const glm::dvec3&) { return pi; });
    EXPECT_TRUE(converges(Radiometer(scene), scene.ray(), open + byTheWall));
}

}  // namespace
}  // namespace render
