// Each shape, anywhere in the world, against the oracle.

#include "gr/scene.h"
#include "gr/shape_oracle.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

class ShapeTest : public testing::TestWithParam<std::size_t> {
protected:
    ShapeTest() : object_(oracleObjects()[GetParam()]) {}

    // Puts the shape somewhere else. Sizes from 0.01 to 100, up to ten times as far away, half of them mirrored.
    Scene place() {
        Database database;
        database.create(":", "shape", object_.content);
        size_ = std::pow(10, 4 * random_.next() - 2);
        database.translate(":shape", randomDirection(random_) * (10 * size_ * random_.next()));
        squeezeAtRandom(database, ":shape", size_, 0.7, random_);
        if (random_.next() < 0.5) database.scale(":shape", glm::dvec3(0), {1, -1, 1});
        object_.worldFromObject = *database.find(":shape").matrix;
        return compile(database, ":", {});
    }

    // From round about the shape, or within it, to somewhere near it.
    core::Rayf aim() {
        const auto point = [&](double radius) {
            return core::Vec3f(transformed(object_.worldFromObject, randomPoint(random_, -radius, radius)));
        };
        const core::Vec3f from = point(random_.next() < 0.3 ? 0.5 : 4);
        return {from, glm::normalize(point(1.2) - from)};
    }

    OracleObject object_;
    double size_ = 0;
    support::TestRandom random_{GetParam() + 1};
};

TEST_P(ShapeTest, IsMetWhereTheOracleSays) {
    int hits = 0, misses = 0, doubtful = 0;
    for (int i = 0; i < 400; ++i) {
        const Scene scene = place();
        const auto accelerator = makeNoAccelerator(scene);
        for (int j = 0; j < 250; ++j) {
            const core::Rayf ray = aim();
            const std::optional<OracleHit> expected = object_.meet({ray.origin, ray.direction});
            if (!expected) {
                ++doubtful;
                continue;
            }
            const std::optional<Hit> hit = accelerator->intersect(ray);
            ASSERT_EQ(hit.has_value(), expected->exists()) << "place " << i << ", ray " << j;
            ASSERT_EQ(accelerator->occluded(ray), expected->exists()) << "place " << i << ", ray " << j;
            ++(hit ? hits : misses);
            if (!hit) continue;

            // The hit is as far off the surface as rounding may put it, so further along the ray where that is grazing.
            const glm::dvec3 normal = glm::normalize(expected->normal);
            const double cosine = std::abs(glm::dot(normal, glm::dvec3(ray.direction)));
            const double reach = size_ + glm::length(glm::dvec3(ray.origin)) + expected->t;
            EXPECT_NEAR(hit->t * cosine, expected->t * cosine, 2e-6 * reach) << "place " << i << ", ray " << j;
            const SurfacePoint surface = scene.surfaceAt(ray, *hit);
            EXPECT_NEAR(glm::length(surface.normal), 1, 1e-6);
            EXPECT_GT(glm::dot(glm::dvec3(surface.normal), normal), 1 - 1e-5) << "place " << i << ", ray " << j;
        }
    }
    // The thinnest shape is met least, the fattest missed least.
    EXPECT_GT(hits, 3000);
    EXPECT_GT(misses, 3000);
    EXPECT_LT(doubtful, 2000);
}

// surfaceAt's point lies on the surface, to within what it says itself, and on the ray.
TEST_P(ShapeTest, ThePointIsOnTheSurface) {
    for (int i = 0; i < 400; ++i) {
        const Scene scene = place();
        const auto accelerator = makeNoAccelerator(scene);
        for (int j = 0; j < 50; ++j) {
            const core::Rayf ray = aim();
            const std::optional<OracleHit> expected = object_.meet({ray.origin, ray.direction});
            const std::optional<Hit> hit = accelerator->intersect(ray);
            if (!expected || !expected->exists() || !hit) continue;
            const SurfacePoint surface = scene.surfaceAt(ray, *hit);
            const OracleRay oracleRay{ray.origin, ray.direction};
            const double reach = size_ + glm::length(oracleRay.origin) + expected->t;
            // Off the ray only sideways, by the margin to the nearest edge at most.
            EXPECT_LT(glm::length(glm::dvec3(surface.position) - oracleRay.at(expected->t)), 5e-4 * reach);
            // From a hair outside, a ray back along the normal meets the surface there.
            const glm::dvec3 normal = glm::normalize(glm::dvec3(surface.normal));
            const double step = 1e-3 * size_;
            const OracleRay back{glm::dvec3(surface.position) + normal * step, -normal};
            const std::optional<OracleHit> there = object_.meet(back);
            if (!there || !there->exists()) continue;
            EXPECT_NEAR(there->t, step, 2 * surface.step + 1e-6 * size_);
        }
    }
}

std::string nameOf(const testing::TestParamInfo<std::size_t>& info) {
    return oracleObjects()[info.param].name;
}

INSTANTIATE_TEST_SUITE_P(All, ShapeTest, testing::Range<std::size_t>(0, oracleObjects().size()), nameOf);

TEST(ShapeOracles, AreThereForEveryShapeOfTheList) {
    std::vector<bool> has(std::variant_size_v<NodeContent>);
    for (const OracleObject& object : oracleObjects()) has[object.content.index()] = true;
    const auto check = [&]<class Node>(const Node& node) { EXPECT_TRUE(has[NodeContent(node).index()]) << Node::kind; };
    [&]<class... Nodes>(std::type_identity<ShapeNodeList<Nodes...>>) {
        (check(Nodes{}), ...);
    }(std::type_identity<ShapeNodes>());
}

}  // namespace
}  // namespace gr
