// Direct light from area lights, against Lambert's polygon formula.
// Seen to fail with the cosine at the surface or at the light dropped, 1/pi dropped, an area 2 % too large or that of
// the untransformed square, a normal that goes the points' way, the samples' sum for their mean, places on one half of
// the light, no shadows, and shadow rays that go on behind the light.
#include "render/converges.h"
#include "render/each_integrator.h"
#include "render/lambert.h"
#include "support/quadrature.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/ext/scalar_constants.hpp>

namespace render {
namespace {

constexpr double pi = glm::pi<double>();
constexpr glm::dvec3 radiance{7, 5, 3};
constexpr core::Rgbf reflectance{0.8f, 0.5f, 0.3f};
constexpr glm::dvec3 yAxis{0, 1, 0};

glm::dmat4 moved(const glm::dvec3& by) {
    return glm::translate(glm::dmat4(1), by);
}

// A small square of floor round a point, and the square light of side 2 at the origin that shines down -y, under a map.
// The floor is small so that it does not hide what of the light is beneath its horizon.
struct FloorAndLight {
    const char* name;
    glm::dvec3 point;
    glm::dvec3 normal;
    std::function<void(gr::Database&)> map = [](gr::Database&) {};
    glm::dmat4 matrix{1};  // the same map

    Polygon light() const {
        Polygon corners;
        for (const glm::dvec4& corner : {glm::dvec4(-1, 0, -1, 1), {1, 0, -1, 1}, {1, 0, 1, 1}, {-1, 0, 1, 1}})
            corners.push_back(glm::dvec3(matrix * corner));
        return corners;
    }
    glm::dvec3 up() const { return glm::normalize(normal); }
    glm::dvec3 tangent() const { return glm::normalize(glm::cross(normal, glm::dvec3(0.3, 0.5, -0.8))); }
    // From close by, so that the light is not in the way.
    core::Rayf ray() const { return rayTowards(point + 0.05 * (tangent() + 0.3 * up()), point); }
    glm::dvec3 shows(const Polygon& light) const {
        return radiance * glm::dvec3(reflectance) * lambertIrradiance(light, point, up()) / pi;
    }
    glm::dvec3 expected() const { return shows(light()); }
};

struct FloorScene : TestScene {
    explicit FloorScene(const FloorAndLight& place) {
        const glm::dvec3 u = 0.01 * place.tangent();
        const glm::dvec3 v = glm::cross(place.up(), u);
        const glm::dvec3& point = place.point;
        addPolygon("floor", {point - u - v, point + u - v, point + u + v, point - u + v}, reflectance);
        addAreaLight("lamp", core::Rgbf(radiance), {0, 0, 0}, 2);
        place.map(database);
    }
};

const std::vector<FloorAndLight>& cases() {
    static const std::vector<FloorAndLight> cases{
        {"right below", {0, -2, 0}, yAxis},
        {"to the side", {2.5, -1.5, 1}, yAxis},
        {"tilted", {1, -2, 0.5}, {-0.5, 0.7, 0.4}},
        {"a corner below the horizon", {0.3, -1, 0.2}, {0.9, 0.4, 0.3}},
        {"half below the horizon", {0.1, -1, 0.1}, {1, 0.05, 0}},
        {"light turned and far off",
         {30, -4, 5},
         {0.2, 1, 0},
         [](gr::Database& database) {
             database.translate(":lamp", {30, 0, 7});
             database.rotate(":lamp", 0, 60);
             database.rotate(":lamp", 1, 20);
         },
         glm::rotate(glm::rotate(moved({30, 0, 7}), pi / 3, {1, 0, 0}), pi / 9, {0, 1, 0})},
        {"light a rectangle",
         {1, -2, 0},
         yAxis,
         [](gr::Database& database) {
             database.scale(":lamp", {1, 0, 0}, {0.25, 5, 1.5});
         },
         glm::scale(moved({1, 0, 0}), {0.25, 5, 1.5}) * moved({-1, 0, 0})},
        {"light a parallelogram",
         {0.4, -2, -0.7},
         {0.1, 1, 0.2},
         [](gr::Database& database) {
             database.scale(":lamp", {0, 0, 0}, {2, 1, 0.5});
             database.rotate(":lamp", 1, 30);
             database.rotate(":lamp", 2, 25);
             database.scale(":lamp", {0, 0, 0}, {0.7, 1, 1.2});
         },
         glm::scale(glm::rotate(glm::rotate(glm::scale(glm::dmat4(1), {2, 1, 0.5}), pi / 6, {0, 1, 0}), pi * 5 / 36,
                                {0, 0, 1}),
                    {0.7, 1, 1.2})},
        {"light mirrored",
         {0.5, -2, 0},
         yAxis,
         [](gr::Database& database) { database.scale(":lamp", {0, 0, 0}, {-1, 1, 1}); },
         glm::scale(glm::dmat4(1), {-1, 1, 1})},
        {"light upside down",
         {0.5, 2, 0},
         -yAxis,
         [](gr::Database& database) { database.scale(":lamp", {0, 0, 0}, {1, -1, 1}); },
         glm::scale(glm::dmat4(1), {1, -1, 1})},
    };
    return cases;
}

// The formula itself, against the integral that it solves.
TEST(LambertFormula, IsTheIntegralOverTheLight) {
    for (const FloorAndLight& place : cases()) {
        const Polygon light = place.light();
        const glm::dvec3 u = light[1] - light[0], v = light[3] - light[0];
        const glm::dvec3 area = glm::cross(u, v);
        const auto irradiance = [&](double s, double t) {
            const glm::dvec3 toLight = light[0] + u * s + v * t - place.point;
            const double distance = glm::length(toLight);
            const double cosine = std::max(0.0, glm::dot(toLight, place.up()) / distance);
            return cosine * std::abs(glm::dot(toLight, area)) / std::pow(distance, 3);
        };
        EXPECT_NEAR(lambertIrradiance(light, place.point, place.up()),
                    support::integrate2d(irradiance, 0, 1, 0, 1, 1e-5), 1e-5)
            << place.name;
    }
}

class AreaLight : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, AreaLight, eachIntegrator, integratorName);

TEST_P(AreaLight, IsAsBrightAsLambertsFormula) {
    for (const FloorAndLight& place : cases())
        EXPECT_TRUE(converges(Radiometer(FloorScene(place)), place.ray(), place.expected())) << place.name;
}

TEST_P(AreaLight, IsAsBrightWithMoreSamples) {
    for (const FloorAndLight& place : cases()) {
        FloorScene scene(place);
        scene.settings.samplesPerLightSource = 16;
        EXPECT_TRUE(converges(Radiometer(scene), place.ray(), place.expected())) << place.name;
    }
}

// 16 independent samples have a 16th of one sample's variance.
TEST_P(AreaLight, IsLessNoisyWithMoreSamples) {
    FloorScene scene(cases()[1]);
    const double one = Radiometer(scene).measure(cases()[1].ray(), 20'000, 3)[0].variance();
    scene.settings.samplesPerLightSource = 16;
    const double sixteen = Radiometer(scene).measure(cases()[1].ray(), 20'000, 4)[0].variance();
    EXPECT_NEAR(one / sixteen, 16, 1);
}

TEST_P(AreaLight, AddsToOthers) {
    const FloorAndLight& place = cases()[0];
    FloorScene scene(place);
    scene.addAreaLight("second", core::Rgbf(radiance), {2, 0, 3}, 1);
    const Polygon second{{1.5, 0, 2.5}, {2.5, 0, 2.5}, {2.5, 0, 3.5}, {1.5, 0, 3.5}};
    EXPECT_TRUE(converges(Radiometer(scene), place.ray(), place.expected() + place.shows(second)));
}

// The blocker's shadow ends in the middle of the light: half of it shines, and that is a rectangle again.
TEST_P(AreaLight, IsSeenInPartBehindABlocker) {
    const FloorAndLight& place = cases()[0];
    FloorScene scene(place);
    scene.addPolygon("blocker", {{0, -1, -1}, {3, -1, -1}, {3, -1, 1}, {0, -1, 1}}, reflectance);
    const Polygon half{{-1, 0, -1}, {0, 0, -1}, {0, 0, 1}, {-1, 0, 1}};
    EXPECT_TRUE(converges(Radiometer(scene), place.ray(), place.shows(half)));
}

TEST_P(AreaLight, IsHiddenByABlockerAndNotByWhatIsBehindIt) {
    const FloorAndLight& place = cases()[0];
    FloorScene scene(place);
    scene.addPolygon("behind", {{-9, 0.1, -9}, {9, 0.1, -9}, {9, 0.1, 9}, {-9, 0.1, 9}}, reflectance);
    EXPECT_TRUE(converges(Radiometer(scene), place.ray(), place.expected()));
    scene.add("ball", gr::SphereNode{{0, -1, 0}, 0.8}, reflectance);
    const Radiometer hidden(scene);
    for (int i = 0; i < 10'000; ++i) ASSERT_EQ(hidden.sample(place.ray(), 1, i), core::Rgbf(0));
}

TEST_P(AreaLight, IsDarkOnItsBackAndHidesOtherLights) {
    const FloorAndLight above{"above", {0.2, 2, 0.1}, -yAxis};
    FloorScene scene(above);
    const Radiometer dark(scene);
    for (int i = 0; i < 1'000; ++i) ASSERT_EQ(dark.sample(above.ray(), 1, i), core::Rgbf(0));
    scene.addAreaLight("hidden", core::Rgbf(100), {0, 0, 0}, 0.9);
    scene.database.translate(":hidden", {0, -0.5, 0});
    scene.database.scale(":hidden", {0, 0, 0}, {1, -1, 1});  // it shines up
    const Radiometer radiometer(scene);
    for (int i = 0; i < 1'000; ++i) ASSERT_EQ(radiometer.sample(above.ray(), 1, i), core::Rgbf(0));
}

}  // namespace
}  // namespace render
