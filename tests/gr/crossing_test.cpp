// A path that goes through a surface goes on behind it, and does not meet the place it came through.
// GRSH_TEST_RAYS=90 traces 10^8 rays.

#include "gr/convex_places.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::Rayf;
using core::Vec3f;

class CrossingTest : public testing::TestWithParam<std::size_t> {
protected:
    CrossingTest() : shape_(convexSolids()[GetParam()]) {}

    ConvexShape shape_;
    const int placesOfEach_ = rayCount(4);
};

// What is convex is entered, met from inside, left, and not met again.
// Seen to fail with a tenth of the error bounds (the sphere and the cube's mesh), a hundredth (the icosphere), and
// without the margin to the edges (the box and the cube's mesh).
TEST_P(CrossingTest, GoesInAndOutOnce) {
    Violations missed, fromOutside, sameFace, metAgain;
    support::TestRandom random(3);
    forEachPlace(shape_, placesOfEach_, random, alone, [&](const ConvexPlace& place) {
        for (int i = 0; i < 1000; ++i) {
            const Rayf ray = place.rayFromOutside(random);
            const std::optional<Hit> hit = place.accelerator->intersect(ray);
            if (!hit) continue;
            const SurfacePoint in = place.scene.surfaceAt(ray, *hit);
            if (!(glm::dot(ray.direction, in.normal) < 0)) continue;  // a mesh's silhouette: see self_hit_test.cpp
            const Rayf inside{in.offset(-in.normal), leave(-in.normal, random)};
            const std::optional<Hit> exit = place.accelerator->intersect(inside);
            if (!exit) {
                missed.add(place.text(), ": step ", in.step);
                continue;
            }
            const SurfacePoint out = place.scene.surfaceAt(inside, *exit);
            const float cosine = glm::dot(inside.direction, out.normal);
            if (!(cosine > 0)) fromOutside.add(place.text(), ": t ", exit->t, ", cosine ", cosine);
            const bool hasFaces = !shape_.isRound || shape_.isMesh;
            if (hasFaces && out.normal == in.normal) sameFace.add(place.text(), ": t ", exit->t, ", step ", in.step);
            const Rayf outside{out.offset(out.normal), leave(out.normal, random)};
            if (const auto again = place.accelerator->intersect(outside))
                metAgain.add(place.text(), ": t ", again->t, ", step ", out.step);
        }
    });
    EXPECT_EQ(missed.count(), 0) << missed.text();
    EXPECT_EQ(fromOutside.count(), 0) << fromOutside.text();
    EXPECT_EQ(sameFace.count(), 0) << sameFace.text();
    EXPECT_EQ(metAgain.count(), 0) << metAgain.text();
}

std::string nameOf(const testing::TestParamInfo<std::size_t>& info) {
    return convexSolids()[info.param].name;
}

INSTANTIATE_TEST_SUITE_P(All, CrossingTest, testing::Range<std::size_t>(0, convexSolids().size()), nameOf);

}  // namespace
}  // namespace gr
