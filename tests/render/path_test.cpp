// How far a path goes, and what it collects on its way.
#include "render/converges.h"
#include "render/each_integrator.h"

namespace render {
namespace {

constexpr core::Rgbf reflectance{0.8f, 0.5f, 0.3f};
constexpr core::Rgbf radiance{7, 5, 3};

// A room with a lamp below its ceiling and something in it, closed but for the way that the camera looks in.
struct Room : TestScene {
    Room() {
        add("room", gr::BoxNode{{-3, -3, -3}, {6, 6, 6}}, reflectance);
        add("ball", gr::SphereNode{{0.5, -1.5, 1}, 1}, core::Rgbf(0.9f));
        addAreaLight("lamp", radiance, {0, 2.5, 0}, 2);
        addPointLight("point", {{-2, 0, -2}, core::Rgbf(0.5f), {0, 0, 1}});
        ambient = core::Rgbf(0);
    }
};

const core::Rayf ray = rayTowards({-1, 0, -2.5}, {0.4, -2, 1});

class Path : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, Path, eachIntegrator, integratorName);

TEST_P(Path, SeesALightAsItIs) {
    for (const bool everything : {false, true}) {
        for (const int pathLength : {1, 2, 5}) {
            Room scene;
            scene.settings.globalIllumination = everything;
            scene.settings.pathLength = pathLength;
            const Radiometer radiometer(scene);
            EXPECT_EQ(radiometer.sample(rayTowards({0, 0, 0}, {0.3, 2.5, 0.8}), 1, 0), radiance);
            EXPECT_EQ(radiometer.sample(rayTowards({-2, 0, 0}, {0.9, 2.5, 0.9}), 1, 0), radiance) << "at a slant";
        }
    }
}

// It is opaque: neither what is behind it is seen nor the background.
TEST_P(Path, SeesALightsBackDark) {
    Room scene;
    scene.settings.globalIllumination = true;
    scene.settings.background = core::Rgbf(1);
    scene.ambient = core::Rgbf(1);
    const Radiometer radiometer(scene);
    for (int i = 0; i < 100; ++i)
        ASSERT_EQ(radiometer.sample(rayTowards({0, 2.9, 0}, {0.3, 2.5, 0.8}), 1, i), core::Rgbf(0));
}

// Another path length draws the same random numbers as far as both paths go, so that a longer path can only add. (The
// path integrator's may take away: what light samples bring counts less where the path may meet the light, too.)
TEST(ReportPath, BringsMoreTheLongerItMayBe) {
    Room scene;
    scene.settings.globalIllumination = true;
    std::vector<std::unique_ptr<Radiometer>> radiometers;
    for (int pathLength = 1; pathLength <= 6; ++pathLength) {
        scene.settings.pathLength = pathLength;
        radiometers.push_back(std::make_unique<Radiometer>(scene));
    }
    std::vector<int> brighter(radiometers.size());
    for (int i = 0; i < 2'000; ++i) {
        core::Rgbf shorter(0);
        for (std::size_t n = 0; n < radiometers.size(); ++n) {
            const core::Rgbf longer = radiometers[n]->sample(ray, 1, i);
            for (int channel = 0; channel < 3; ++channel) ASSERT_GE(longer[channel], shorter[channel]);
            if (longer != shorter) ++brighter[n];
            shorter = longer;
        }
    }
    // Few paths end before their sixth point, at the lamp.
    for (std::size_t n = 0; n < radiometers.size(); ++n) EXPECT_GT(brighter[n], 1'000) << n + 1 << " points";
}

TEST_P(Path, OfOnePointIsAllThereIsWithoutGlobalIllumination) {
    Room off, one;
    off.ambient = one.ambient = core::Rgbf(0.3f);
    off.settings.pathLength = 7;
    one.settings.pathLength = 1;
    one.settings.globalIllumination = true;
    const Radiometer radiometerOff(off), radiometerOne(one);
    for (int i = 0; i < 1'000; ++i) ASSERT_EQ(radiometerOff.sample(ray, 1, i), radiometerOne.sample(ray, 1, i));
}

TEST(ReportPath, CountsItsRays) {
    Room scene;
    scene.database.remove(":lamp");  // no path ends but by its length
    scene.settings.globalIllumination = true;
    scene.settings.pathLength = 4;
    const Radiometer radiometer(scene);
    RayCounts rays;
    for (int i = 0; i < 100; ++i) {
        Sampler sampler(1, 0, 0, i);
        radiometer.integrator().radiance(ray, sampler, rays);
    }
    EXPECT_EQ(rays.camera, 100u);
    EXPECT_EQ(rays.diffuse, 300u);
    EXPECT_LE(rays.shadow, 400u);
    EXPECT_GT(rays.shadow, 300u) << "few points have the point light behind them";
    EXPECT_EQ(rays.total(), rays.camera + rays.shadow + rays.diffuse);
}

// Every draw comes from the sampler, and nothing is kept between paths.
TEST(ReportPath, DependsOnItsSamplerAlone) {
    Room scene;
    scene.settings.globalIllumination = true;
    scene.settings.pathLength = 4;
    const Radiometer radiometer(scene);
    std::vector<core::Rgbf> forwards, backwards;
    for (int i = 0; i < 500; ++i) forwards.push_back(radiometer.sample(ray, 1, i));
    for (int i = 500; i-- > 0;) backwards.push_back(radiometer.sample(ray, 1, i));
    std::reverse(backwards.begin(), backwards.end());
    EXPECT_EQ(forwards, backwards);
    int same = 0;
    for (int i = 0; i < 500; ++i) same += radiometer.sample(ray, 2, i) == forwards[static_cast<std::size_t>(i)] ? 1 : 0;
    EXPECT_EQ(same, 0) << "another seed draws other numbers";
}

}  // namespace
}  // namespace render
