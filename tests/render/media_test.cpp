// What a path is inside of.
// Seen to fail with an outer medium that is forgotten, air where one of two that overlap is left, all of one material
// left at once, another medium left for one that was not entered, one met from inside entered twice, and the medium of
// the eye taken for all of its lens.
#include "render/transport/media.h"

#include "render/converges.h"
#include "render/each_integrator.h"

namespace render {
namespace {

using core::Vec3f;
using materials::Dielectric;
using materials::Interior;

const Interior water{.index = 1.25, .absorption = {1, 0, 0}};
const Interior glass{.index = 1.5, .absorption = {0, 1, 0}};

TEST(Media, AreAirAtFirst) {
    const Media media;
    EXPECT_EQ(media.index(), 1);
    EXPECT_EQ(media.indexBeyond(glass, true), 1.5f);
    EXPECT_EQ(media.transmittance(100), core::Rgbf(1));
    EXPECT_EQ(media.transmittance(core::infinity), core::Rgbf(1));
}

TEST(Media, LieInOneAnother) {
    Media media;
    media.cross(water, true);
    EXPECT_EQ(media.index(), 1.25f);
    EXPECT_EQ(media.indexBeyond(water, false), 1);
    EXPECT_EQ(media.indexBeyond(glass, true), 1.5f);
    media.cross(glass, true);
    EXPECT_EQ(media.index(), 1.5f);
    EXPECT_EQ(media.transmittance(1).x, 1);
    EXPECT_NEAR(media.transmittance(1).y, std::exp(-1), 1e-6);
    EXPECT_EQ(media.indexBeyond(glass, false), 1.25f);
    media.cross(glass, false);
    EXPECT_EQ(media.index(), 1.25f);
    media.cross(water, false);
    EXPECT_EQ(media.index(), 1);
}

// Where two overlap, the one entered last counts until it is left; leaving the other changes nothing.
TEST(Media, Overlap) {
    Media media;
    media.cross(water, true);
    media.cross(glass, true);
    EXPECT_EQ(media.indexBeyond(water, false), 1.5f);
    media.cross(water, false);
    EXPECT_EQ(media.index(), 1.5f);
    EXPECT_EQ(media.indexBeyond(glass, false), 1);
    media.cross(glass, false);
    EXPECT_EQ(media.index(), 1);
}

TEST(Media, MayBeOneMaterialTwice) {
    Media media;
    media.cross(glass, true);
    EXPECT_EQ(media.indexBeyond(glass, true), 1.5f);
    media.cross(glass, true);
    EXPECT_EQ(media.indexBeyond(glass, false), 1.5f);
    media.cross(glass, false);
    EXPECT_EQ(media.index(), 1.5f);
    media.cross(glass, false);
    EXPECT_EQ(media.index(), 1);
}

TEST(Media, AreNotLeftWhereTheyWereNotEntered) {
    Media media;
    EXPECT_EQ(media.indexBeyond(glass, false), 1);
    media.cross(glass, false);
    EXPECT_EQ(media.index(), 1);
    media.cross(water, true);
    EXPECT_EQ(media.indexBeyond(glass, false), 1.25f);
    media.cross(glass, false);
    EXPECT_EQ(media.index(), 1.25f);
}

TEST(Media, AreKnownFromASurfaceMetFromBehind) {
    Media media;
    media.meetFromInside(glass);
    EXPECT_EQ(media.index(), 1.5f);
    media.meetFromInside(glass);
    media.cross(glass, false);
    EXPECT_EQ(media.index(), 1);
    media.cross(water, true);
    media.cross(glass, true);
    media.meetFromInside(water);
    EXPECT_EQ(media.index(), 1.5f) << "known already";
}

class MediaOfTheLens : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, MediaOfTheLens, eachIntegrator, integratorName);

// The surface of a tank cuts through the lens: a ray knows which part of it it comes from.
TEST_P(MediaOfTheLens, AreThoseOfThePlaceOnIt) {
    TestScene scene;
    scene.settings.globalIllumination = true;
    scene.settings.background = core::Rgbf(1);
    scene.settings.pathLength = 4;
    scene.settings.depthOfField = true;
    scene.settings.aperture = 0.5;
    scene.add("tank", gr::BoxNode{{-3, -3, -3}, {6, 3, 6}}, Dielectric{.index = 1, .absorption = {1, 0, 0.5f}});
    for (const double height : {-0.1, 0.1}) {
        const Radiometer radiometer(scene, {0, height, 0});
        const core::Rgbf below = radiometer.sample({{0.2f, -0.1f, 0}, {0, 0, 1}}, 1, 0);
        const core::Rgbf above = radiometer.sample({{0.2f, 0.1f, 0}, {0, 0, 1}}, 1, 0);
        EXPECT_TRUE(isNear(below, glm::dvec3(std::exp(-3), 1, std::exp(-1.5)))) << "eye at " << height;
        EXPECT_EQ(above, core::Rgbf(1)) << "eye at " << height;
    }
}

class MediaOfOpenSurfaces : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, MediaOfOpenSurfaces, eachIntegrator, integratorName);

// A glass surface without an end, seen from behind: the way to it was in glass, though nothing was entered.
TEST_P(MediaOfOpenSurfaces, BeginAtTheEye) {
    TestScene scene;
    scene.settings.globalIllumination = true;
    scene.settings.background = core::Rgbf(1);
    // Too small to be met by the search for what the eye is in.
    scene.addPolygon("surface", {{-0.1, 0, 0.1}, {0.1, 0, 0.1}, {0.1, 0, -0.1}, {-0.1, 0, -0.1}},
                     Dielectric{.index = 1, .absorption = {1, 0, 0.5f}});
    EXPECT_TRUE(isNear(Radiometer(scene, {0, -2, 0}).sample(rayTowards({0, -2, 0}, {0.05, 0, 0.01}), 1, 0),
                       glm::exp(-std::hypot(2, 0.05, 0.01) * glm::dvec3(1, 0, 0.5))));
}

}  // namespace
}  // namespace render
