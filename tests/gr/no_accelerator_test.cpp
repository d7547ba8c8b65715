// The linear search finds the nearest of all objects, in scenes of many kinds mixed.

#include "gr/scene.h"
#include "gr/shape_oracle.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

// Some objects round about [-2, 2]^3, some of them meshes that stand in the world as they are.
std::vector<OracleObject> randomObjects(support::TestRandom& random) {
    static const std::vector<OracleObject> kinds = oracleObjects();
    std::vector<OracleObject> objects;
    const int count = 1 + static_cast<int>(25 * random.next());
    for (int i = 0; i < count; ++i) {
        const double size = 0.2 + random.next();
        const glm::dvec3 centre = randomPoint(random, -2, 2);
        if (random.next() < 0.3) {
            // More triangles than fit beside others', or fewer.
            PolygonMesh mesh = icosphereMesh(random.next() < 0.3 ? 1 : 0);
            for (glm::dvec3& v : mesh.vertices) v = v * size + centre;
            objects.push_back(oracleMesh("Icosphere", mesh));
            continue;
        }
        Database database;
        database.create(":", "place", TransformNode{});
        database.translate(":place", centre);
        squeezeAtRandom(database, ":place", size, 0.7, random);
        objects.push_back(kinds[static_cast<std::size_t>(random.next() * static_cast<double>(kinds.size()))]);
        objects.back().worldFromObject = *database.find(":place").matrix;
    }
    return objects;
}

Scene sceneOf(const std::vector<OracleObject>& objects) {
    Database database;
    for (const OracleObject& object : objects) {
        Node& node = database.create(":", "object" + std::to_string(database.nodeCount()), object.content);
        if (object.worldFromObject != glm::dmat4(1)) node.matrix = std::make_unique<glm::dmat4>(object.worldFromObject);
    }
    return compile(database, ":", {});
}

struct Nearest {
    double t = std::numeric_limits<double>::infinity();
    std::size_t object = 0;
};

// Nothing where rounding may decide what is hit, or whether before tMax.
std::optional<Nearest> nearestOf(const std::vector<OracleObject>& objects, const core::Rayf& ray) {
    Nearest nearest;
    std::vector<double> all{ray.tMax};
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const std::optional<OracleHit> hit = objects[i].meet({ray.origin, ray.direction});
        if (!hit) return std::nullopt;
        all.push_back(hit->t);
        if (hit->t < ray.tMax && hit->t < nearest.t) nearest = {hit->t, i};
    }
    const double first = std::min(nearest.t, static_cast<double>(ray.tMax));
    const auto isClose = [&](double t) { return std::isfinite(t) && std::abs(t - first) < 1e-3 * (1 + first); };
    return std::count_if(all.begin(), all.end(), isClose) > 1 ? std::nullopt : std::optional(nearest);
}

TEST(NoAccelerator, AgreesWithTheOracle) {
    support::TestRandom random(1);
    int hits = 0, misses = 0, doubtful = 0;
    for (int i = 0; i < 200; ++i) {
        const std::vector<OracleObject> objects = randomObjects(random);
        const Scene scene = sceneOf(objects);
        ASSERT_EQ(scene.instances.size(), objects.size());
        const auto accelerator = makeNoAccelerator(scene);
        for (int j = 0; j < 200; ++j) {
            const core::Vec3f from(randomPoint(random, -5, 5)), to(randomPoint(random, -2, 2));
            core::Rayf ray{from, (to - from) * static_cast<float>(0.1 + random.next())};
            // Half of the rays end before or behind what they meet.
            if (const auto hit = accelerator->intersect(ray); hit && random.next() < 0.5)
                ray.tMax = hit->t * static_cast<float>(0.5 + random.next());
            const std::optional<Nearest> expected = nearestOf(objects, ray);
            if (!expected) {
                ++doubtful;
                continue;
            }
            const std::optional<Hit> hit = accelerator->intersect(ray);
            const bool isMet = std::isfinite(expected->t);
            ASSERT_EQ(hit.has_value(), isMet) << "scene " << i << ", ray " << j;
            ASSERT_EQ(accelerator->occluded(ray), isMet) << "scene " << i << ", ray " << j;
            ++(isMet ? hits : misses);
            if (!isMet) continue;
            ASSERT_EQ(hit->instance, expected->object) << "scene " << i << ", ray " << j;
            ASSERT_NEAR(hit->t, expected->t, 1e-3 * (1 + expected->t)) << "scene " << i << ", ray " << j;
            ASSERT_LT(hit->t, ray.tMax);
        }
    }
    EXPECT_GT(hits, 10'000);
    EXPECT_GT(misses, 10'000);
    EXPECT_LT(doubtful, 4'000);
}

TEST(NoAccelerator, AnEmptySceneHasNothingToMeet) {
    const Scene scene;
    const auto accelerator = makeNoAccelerator(scene);
    EXPECT_EQ(accelerator->intersect({{0, 0, 0}, {0, 0, 1}}), std::nullopt);
    EXPECT_FALSE(accelerator->occluded({{0, 0, 0}, {0, 0, 1}}));
}

// Any number of objects of a kind, so that every lane of a pack is the last one once.
TEST(NoAccelerator, FindsEachOfAFew) {
    for (const OracleObject& kind : oracleObjects()) {
        if (std::holds_alternative<PlaneNode>(kind.content)) continue;  // it is everywhere
        const core::Vec3f below(static_cast<float>(kind.over.x), -5, static_cast<float>(kind.over.y));
        for (int count = 1; count <= 9; ++count) {
            std::vector<OracleObject> objects(static_cast<std::size_t>(count), kind);
            for (int i = 0; i < count; ++i) objects[i].worldFromObject[3] = glm::dvec4(10 * i, 0, 0, 1);
            const Scene scene = sceneOf(objects);
            const auto accelerator = makeNoAccelerator(scene);
            for (int i = 0; i < count; ++i) {
                const core::Rayf ray{below + core::Vec3f(10 * i, 0, 0), {0, 1, 0}};
                const std::optional<Hit> hit = accelerator->intersect(ray);
                ASSERT_TRUE(hit.has_value()) << i << " of " << count;
                EXPECT_EQ(hit->instance, i) << "of " << count;
                EXPECT_TRUE(accelerator->occluded(ray));
                EXPECT_FALSE(accelerator->intersect({below + core::Vec3f(10 * i + 5, 0, 0), {0, 1, 0}}));
            }
        }
    }
}

TEST(NoAccelerator, OfCoincidingSurfacesTheFirstIsMet) {
    for (const OracleObject& kind : oracleObjects()) {
        const std::vector<OracleObject> objects(7, kind);
        const Scene scene = sceneOf(objects);
        const auto hit = makeNoAccelerator(scene)->intersect(
            {{static_cast<float>(kind.over.x), -5, static_cast<float>(kind.over.y)}, {0, 1, 0}});
        ASSERT_TRUE(hit.has_value());
        EXPECT_EQ(hit->instance, 0);
    }
}

}  // namespace
}  // namespace gr
