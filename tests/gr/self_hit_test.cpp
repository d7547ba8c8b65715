// A path that leaves a surface goes on from the side it came to, and does not meet the place it left.
// GRSH_TEST_RAYS=40 traces 10^8 rays.

#include "gr/convex_places.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::Rayf;
using core::Vec3f;

class SelfHitTest : public testing::TestWithParam<std::size_t> {
protected:
    SelfHitTest() : shape_(convexShapes()[GetParam()]) {}

    ConvexShape shape_;
    const int placesOfEach_ = rayCount(4);
};

// What is convex is not met again from outside. Seen to fail with a tenth of the error bounds (all but the square), and
// where surfaceAt takes the normal as it comes (the sphere's side).
TEST_P(SelfHitTest, FromOutsideItIsNotMetAgain) {
    Violations metAgain, wrongSide;
    support::TestRandom random(1);
    forEachPlace(shape_, placesOfEach_, random, alone, [&](const ConvexPlace& place) {
        for (int i = 0; i < 1000; ++i) {
            const Rayf ray = place.rayFromOutside(random);
            const std::optional<Hit> hit = place.accelerator->intersect(ray);
            if (!hit) continue;
            const SurfacePoint surface = place.scene.surfaceAt(ray, *hit);
            const float cosine = glm::dot(ray.direction, surface.normal);
            // A mesh only nearly so: of two triangles at its silhouette, 10^-7 apart, the one behind may seem nearer.
            if (!(cosine < 0) && !shape_.isFlat && !shape_.isMesh) wrongSide.add(place.text(), ": cosine ", cosine);
            const Vec3f side = shape_.isFlat && cosine > 0 ? -surface.normal : surface.normal;
            for (int j = 0; j < 2; ++j) {
                const Rayf next{surface.offset(side), leave(side, random)};
                if (const auto again = place.accelerator->intersect(next))
                    metAgain.add(place.text(), ": t ", again->t, ", step ", surface.step, ", cosine ",
                                 glm::dot(next.direction, side));
            }
        }
    });
    EXPECT_EQ(metAgain.count(), 0) << metAgain.text();
    EXPECT_EQ(wrongSide.count(), 0) << wrongSide.text();
}

class SelfHitInsideTest : public testing::TestWithParam<std::size_t> {
protected:
    SelfHitInsideTest() : shape_(closedShapes()[GetParam()]) {}

    ConvexShape shape_;
    const int placesOfEach_ = rayCount(4);
};

// From within, a path bounces about for ever: each ray meets the inside again, and never the flat face that it left.
// Seen to fail with a tenth of the error bounds, and without the margin to the edges.
TEST_P(SelfHitInsideTest, FromInsideItIsNeverLeft) {
    Violations escaped, fromOutside, sameFace;
    support::TestRandom random(2);
    forEachPlace(shape_, placesOfEach_, random, alone, [&](const ConvexPlace& place) {
        for (int path = 0; path < 50; ++path) {
            Rayf ray{place.toWorld(shape_.inside), Vec3f(randomDirection(random))};
            Vec3f lastNormal(0);
            for (int bounce = 0; bounce < 60; ++bounce) {
                const std::optional<Hit> hit = place.accelerator->intersect(ray);
                if (!hit) {
                    escaped.add(place.text(), ": bounce ", bounce);
                    break;
                }
                const SurfacePoint surface = place.scene.surfaceAt(ray, *hit);
                const float cosine = glm::dot(ray.direction, surface.normal);
                if (cosine < 0) fromOutside.add(place.text(), ": bounce ", bounce, ", t ", hit->t, ", cosine ", cosine);
                const bool hasFaces = !shape_.isRound || shape_.isMesh;
                if (hasFaces && surface.normal == lastNormal)
                    sameFace.add(place.text(), ": bounce ", bounce, ", t ", hit->t, ", step ", surface.step);
                lastNormal = surface.normal;
                ray = {surface.offset(-surface.normal), leave(-surface.normal, random)};
            }
        }
    });
    EXPECT_EQ(escaped.count(), 0) << escaped.text();
    EXPECT_EQ(fromOutside.count(), 0) << fromOutside.text();
    EXPECT_EQ(sameFace.count(), 0) << sameFace.text();
}

std::string nameOf(const testing::TestParamInfo<std::size_t>& info) {
    return convexShapes()[info.param].name;
}

// A ray along a plane that has no end comes back to it, if rounding turns it down: but only from far, and from the side
// that it was on.
TEST(SelfHitPlane, IsMetAgainFromItsFrontAlone) {
    Violations early, fromBelow;
    support::TestRandom random(3);
    const ConvexShape plane{"Plane", PlaneNode{}, false, true, false};
    forEachPlace(plane, rayCount(4), random, alone, [&](const ConvexPlace& place) {
        for (int i = 0; i < 1000; ++i) {
            const Rayf ray = place.rayFromOutside(random);
            const std::optional<Hit> hit = place.accelerator->intersect(ray);
            if (!hit) continue;
            const SurfacePoint surface = place.scene.surfaceAt(ray, *hit);
            const Vec3f side = glm::dot(ray.direction, surface.normal) > 0 ? -surface.normal : surface.normal;
            const Rayf next{surface.offset(side), leave(side, random)};
            const auto again = place.accelerator->intersect(next);
            if (!again) continue;
            if (again->t < 1e4f * surface.step) early.add(place.text(), ": t ", again->t, ", step ", surface.step);
            const SurfacePoint there = place.scene.surfaceAt(next, *again);
            const bool isOnNormalsSide = glm::dot(there.normal, side) > 0;
            if ((glm::dot(next.direction, there.normal) < 0) != isOnNormalsSide)
                fromBelow.add(place.text(), ": t ", again->t);
        }
    });
    EXPECT_EQ(early.count(), 0) << early.text();
    EXPECT_EQ(fromBelow.count(), 0) << fromBelow.text();
}

INSTANTIATE_TEST_SUITE_P(All, SelfHitTest, testing::Range<std::size_t>(0, convexShapes().size()), nameOf);

std::string nameOfClosed(const testing::TestParamInfo<std::size_t>& info) {
    return closedShapes()[info.param].name;
}

INSTANTIATE_TEST_SUITE_P(All, SelfHitInsideTest, testing::Range<std::size_t>(0, closedShapes().size()), nameOfClosed);

}  // namespace
}  // namespace gr
