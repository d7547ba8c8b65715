// What a path is inside of.
// Seen to fail with an outer medium that is forgotten, air where one of two that overlap is left, all of one material
// left at once, another medium left for one that was not entered, one met from inside entered twice, the order from the
// eye outwards for the one back to it, opaque things that end the search, and a lens that is taken to be where the eye
// is.
#include "render/media.h"

#include "render/converges.h"
#include "render/each_integrator.h"

namespace render {
namespace {

using core::Vec3f;
using materials::Dielectric;

const Dielectric water{.index = 1.25, .absorption = {1, 0, 0}};
const Dielectric glass{.index = 1.5, .absorption = {0, 1, 0}};

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

// A drop of glass in a ball of water, with opaque things in it and about it.
class Drop : public testing::Test {
protected:
    Drop() {
        add("water", {0, 0, 0}, 4, water);
        add("drop", {0, 0, 0}, 1, glass);
        add("stone", {2, 0, 0}, 0.5, materials::Diffuse{});
        add("shell", {0, 0, 0}, 9, materials::Shirley{});
        database_.create(":", "lamp", gr::AreaLightNode{core::Rgbf(1), {0, 1.5, 0}, 30});
        scene_ = gr::compile(database_, ":", {});
        accelerator_ = gr::makeNoAccelerator(scene_);
    }
    void add(const std::string& name, const glm::dvec3& centre, double radius, const materials::Material& material) {
        database_.create(":", name, gr::SphereNode{centre, radius});
        database_.addMaterial(name, material);
        database_.setMaterial(":" + name, name);
    }
    Media at(const Vec3f& point) const { return mediaAt(point, scene_, *accelerator_); }

    gr::Database database_;
    gr::Scene scene_;
    std::unique_ptr<gr::Accelerator> accelerator_;
};

TEST_F(Drop, IsFoundFromWhereverTheEyeIs) {
    EXPECT_EQ(at({0.1f, 0.2f, -0.3f}).index(), 1.5f);
    EXPECT_EQ(at({-2, 0, 1}).index(), 1.25f);
    EXPECT_EQ(at({-2, -2, -2}).index(), 1.25f) << "the drop is on the way out";
    EXPECT_EQ(at({2, 0, 0}).index(), 1.25f) << "in the stone";
    EXPECT_EQ(at({-4, -4, -4}).index(), 1) << "all of it is on the way out";
    EXPECT_EQ(at({20, 0, 0}).index(), 1);
}

TEST_F(Drop, IsLeftAsItWasEntered) {
    Media media = at({0, 0, 0});
    const auto* drop = std::get_if<Dielectric>(&scene_.materials[scene_.instances[1].material]);
    ASSERT_TRUE(drop != nullptr && drop->index == 1.5);
    EXPECT_EQ(media.indexBeyond(*drop, false), 1.25f);
}

TEST_F(Drop, IsGoneThrough) {
    const std::pair<Vec3f, float> places[] = {{{0, 0, 0}, 1.5f},  {{0, -2, 0}, 1.25f},    {{0, 0, -5}, 1},
                                              {{3, 0, 0}, 1.25f}, {{-3, 0.5f, 0}, 1.25f}, {{0, 12, 0}, 1}};
    for (const auto& [from, before] : places) {
        for (const auto& [to, after] : places) {
            Media media = at(from);
            ASSERT_EQ(media.index(), before);
            EXPECT_GE(goTo(media, from, to, scene_, *accelerator_), 1);
            EXPECT_EQ(media.index(), after);
        }
    }
    Media media = at({0, 0, 0});
    EXPECT_EQ(goTo(media, {0, 0, 0}, {0, 0, 0.5f}, scene_, *accelerator_), 1);
    EXPECT_EQ(goTo(media, {0, 0, 0}, {0, 0, 2}, scene_, *accelerator_), 2);
}

class MediaOfTheLens : public EachIntegrator {};
INSTANTIATE_TEST_SUITE_P(By, MediaOfTheLens, eachIntegrator, integratorName);

// The surface of a tank cuts through the lens: a ray knows which part of it it comes from.
TEST_P(MediaOfTheLens, AreThoseOfThePlaceOnIt) {
    TestScene scene;
    scene.settings.globalIllumination = true;
    scene.settings.background = core::Rgbf(1);
    scene.settings.pathLength = 4;
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
