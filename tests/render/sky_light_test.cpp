// Light from a sky and from suns, in scenes.
// Seen to fail with a sky that both ways to find it bring in full, one that no ray meets, shadow rays that end at
// distance 1, walls at a scene's edge that cast no shadow, and a sun's disc as bright as its colour.
#include "gr/sky_pictures.h"
#include "render/converges.h"
#include "render/each_integrator.h"
#include "support/quadrature.h"

namespace render {
namespace {

using materials::Dielectric;

struct SkyScene : TestScene {
    template<class F>
    void setSky(int width, int height, F&& f, double degrees = 0) {
        aroundIt = {std::make_shared<gr::SkyGrid>(gr::skyOf(width, height, std::forward<F>(f))), degrees};
    }
    void addFloor(const core::Rgbf& reflectance) {
        add("floor", gr::BoxNode{{-50, -1, -50}, {100, 1, 100}}, reflectance);
    }
};
constexpr core::Rgbf even{5, 3, 2};
core::Rgbf evenSky(double, double) {
    return even;
}
const core::Rayf down{{0.1f, 2, 0.2f}, {0, -1, 0}};

class SkyLight : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, SkyLight, eachIntegrator, integratorName);

// A white ball in an even sky cannot be seen, nor can glass.
TEST_P(SkyLight, OfAnEvenPictureHidesAWhiteBall) {
    SkyScene scene;
    scene.setSky(8, 4, evenSky);
    scene.settings.globalIllumination = true;
    scene.settings.pathLength = 300;
    scene.add("ball", gr::SphereNode{{0, 0, 0}, 1}, core::Rgbf(1));
    EXPECT_TRUE(converges(Radiometer(scene), rayTowards({0, 0, 4}, {0.3, 0.2, 0}), even));
    EXPECT_TRUE(isNear(Radiometer(scene).sample(rayTowards({0, 0, 4}, {0.3, 3, 0}), 1, 0), even));
}

TEST_P(SkyLight, ComesThroughGlassInFull) {
    SkyScene scene;
    scene.setSky(8, 4, evenSky);
    scene.settings.globalIllumination = true;
    scene.settings.pathLength = 400;
    scene.add("ball", gr::SphereNode{{0.1, 0, -0.2}, 1}, Dielectric{.index = 1.5});
    const core::Rayf ray = rayTowards({0, 0, 4}, {0.3, 0.2, 0});
    const Radiometer radiometer(scene, ray.origin);
    for (int path = 0; path < 100; ++path) ASSERT_TRUE(isNear(radiometer.sample(ray, 1, path), even));
}

// What is in front comes back from a mirror, whichever way the sky is turned.
TEST_P(SkyLight, IsSeenInAMirror) {
    SkyScene scene;
    scene.settings.globalIllumination = true;
    const auto ramp = [](double u, double v) { return core::Rgbf(static_cast<float>(u), static_cast<float>(v), 1); };
    scene.setSky(64, 32, ramp, 90);
    scene.add("mirror", gr::BoxNode{{-2, -1, -2}, {4, 1, 4}},
              Dielectric{.index = 1e9, .sampling = core::Weights{0, 1, 0, 0}});
    // Down and in front, and so up and in front.
    const core::Rayf ray{{0, 1, 1}, glm::normalize(core::Vec3f(0, -1, -1))};
    // The sky is turned to the left: in front there is what was on the right.
    EXPECT_TRUE(isNear(Radiometer(scene, ray.origin).sample(ray, 1, 0), glm::dvec3(0.75, 0.25, 1)));
}

// A white floor under a sky whose upper half is L(angle from above): the integral of L cos over the hemisphere / pi.
TEST_P(SkyLight, OnAFloorIsThatOfQuadrature) {
    SkyScene scene;
    scene.settings.pathLength = 1;
    const auto radiance = [](double u, double v) {
        return v < 0.5 ? core::Rgbf(static_cast<float>(1 + std::cos(2 * M_PI * u)), static_cast<float>(v), 1)
                       : core::Rgbf(0);
    };
    scene.setSky(64, 32, radiance, 50);
    scene.addFloor(core::Rgbf(1));
    const gr::SkyGrid& grid = *scene.aroundIt.grid;
    for (int c = 0; c < 3; ++c) {
        // dw = sin du dv 2 pi^2; over pi.
        double expected = 0;
        constexpr int n = 640;
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const double u = (x + 0.5) / n, v = (y + 0.5) / (2. * n), angle = M_PI * v;
                const auto seen = grid.at(static_cast<float>(u), static_cast<float>(v));
                expected +=
                    double{seen.radiance[c]} * grid.unit() * std::sin(angle) * std::cos(angle) * M_PI / (double{n} * n);
            }
        const RgbMean mean = Radiometer(scene).measure(down, 100'000, 7);
        const auto result = support::zTest(mean[static_cast<std::size_t>(c)], expected);
        EXPECT_TRUE(result.accepted) << c << ": " << result.text;
    }
}

TEST_P(SkyLight, IsHiddenByWhatStandsBefore) {
    SkyScene scene;
    scene.settings.pathLength = 1;
    scene.setSky(8, 4, evenSky);
    scene.addFloor(core::Rgbf(1));
    EXPECT_TRUE(converges(Radiometer(scene), down, even));
    // A wall without end on one side takes half of it; it stands at the edge of what there is.
    scene.addPolygon("wall", {{50, 0, -100}, {50, 0, 100}, {50, 100, 100}, {50, 100, -100}}, core::Rgbf(0));
    const core::Rayf beside{{49.99f, 2, 0.2f}, {0, -1, 0}};
    EXPECT_TRUE(converges(Radiometer(scene), beside, even * 0.5f));
}

// As bright on a floor as its colour times the cosine, whatever its size.
TEST_P(SkyLight, OfASunShowsItsColourOnWhite) {
    for (const double degrees : {0., 0.53, 30.}) {
        SkyScene scene;
        scene.settings.pathLength = 1;
        scene.addFloor(core::Rgbf(0.5f));
        const glm::dvec3 along(1, -2, 0.5);
        const core::Rgbf colour(3, 2, 1);
        if (degrees == 0)
            scene.addLight("sun", gr::ParallelLight::make(along, colour));
        else
            scene.addLight("sun", gr::SunLight::make(along, colour, degrees));
        const float cosine = static_cast<float>(2 / glm::length(along));
        EXPECT_TRUE(converges(Radiometer(scene), down, colour * (0.5f * cosine))) << degrees;
        // A shutter far away takes all of it.
        scene.add("shutter", gr::BoxNode{glm::dvec3(-300, 590, -300), {400, 1, 400}}, core::Rgbf(0));
        EXPECT_EQ(Radiometer(scene).sample(down, 1, 0), core::Rgbf(0)) << degrees;
    }
}

// A ray that leaves the scene sees the disc, and of a point nothing.
TEST_P(SkyLight, OfASunIsSeen) {
    SkyScene scene;
    scene.addFloor(core::Rgbf(0.5f));
    scene.addLight("sun", gr::SunLight::make({0, -1, -1}, core::Rgbf(1, 2, 3), 10));
    scene.addLight("point", gr::ParallelLight::make({0, -1, -1}, core::Rgbf(100)));
    const double sine = std::sin(5 * M_PI / 180);
    const core::Rayf towards{{0, 1, 0}, glm::normalize(core::Vec3f(0, 1, 1))};
    EXPECT_TRUE(isNear(Radiometer(scene).sample(towards, 1, 0), glm::dvec3(1, 2, 3) / (sine * sine)));
    const core::Rayf beside{{0, 1, 0}, glm::normalize(core::Vec3f(0.2f, 1, 1))};
    EXPECT_EQ(Radiometer(scene).sample(beside, 1, 0), core::Rgbf(0));
}

// What absorbs for ever lets nothing through, as of a background.
TEST_P(SkyLight, IsLostInAMediumWithoutEnd) {
    SkyScene scene;
    scene.settings.globalIllumination = true;
    scene.settings.pathLength = 4;
    scene.setSky(8, 4, evenSky);
    scene.add("sea", gr::PlaneNode{{0, 0, 0}, {0, 1, 0}}, Dielectric{.index = 1, .absorption = {0.1f, 0, 0.1f}});
    const core::Rayf under{{0, -1, 0}, {0, -1, 0}};
    const core::Rgbf seen = Radiometer(scene, under.origin).sample(under, 1, 0);
    EXPECT_TRUE(isNear(seen, glm::dvec3(0, even.y, 0)));
}

}  // namespace
}  // namespace render
