// Meshes and instances: every accelerator finds what the linear search finds. All seen to fail where a grid's walk
// leaves out the last cell beside its way through a slice, and where one ends before the ray does.

#include "gr/accelerator_checks.h"

namespace gr {
namespace {

PolygonMesh triangleSoup(int triangles, double size, support::TestRandom& random) {
    PolygonMesh mesh;
    for (int i = 0; i < triangles; ++i) {
        const glm::dvec3 at = randomPoint(random, -1, 1);
        const auto first = static_cast<int>(mesh.vertices.size());
        for (int corner = 0; corner < 3; ++corner) mesh.vertices.push_back(at + randomPoint(random, -size, size));
        mesh.faces.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

// Small ones, and some that reach across many cells.
TEST(AcceleratorMesh, TenThousandTriangles) {
    for (const double size : {0.02, 0.3}) {
        support::TestRandom random(3);
        Database database;
        database.create(":", "soup", polyhedronNode(triangleSoup(10'000, size, random)));
        expectSameHits(compile(database, ":", {}), rayCount(500));
    }
}

// Needles and splinters that fill little of their bounds.
TEST(AcceleratorMesh, ThinTriangles) {
    support::TestRandom random(4);
    PolygonMesh mesh;
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 from = randomPoint(random, -1, 1), to = randomPoint(random, -1, 1);
        const auto first = static_cast<int>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {from, to, from + randomPoint(random, -1, 1) * 1e-3});
        mesh.faces.push_back({first, first + 1, first + 2});
    }
    Database database;
    database.create(":", "splinters", polyhedronNode(mesh));
    expectSameHits(compile(database, ":", {}), rayCount(3000));
}

// Of every kind, turned, stretched and some mirrored at each of four levels of instances. Seen to fail where a mesh's
// last triangle is left out of Embree's tree.
TEST(AcceleratorMesh, InstancesNestedFourDeep) {
    for (int seed = 5; seed < 10; ++seed) {
        support::TestRandom random(static_cast<std::uint64_t>(seed));
        Database database;
        const auto place = [&](const std::string& path, double spread) {
            database.translate(path, randomPoint(random, -spread, spread));
            squeezeAtRandom(database, path, 0.5 + random.next(), 0.7, random);
            if (random.next() < 0.5) database.scale(path, glm::dvec3(0), {-1, 1, 0.5});
        };
        database.create(":", "model0", TransformNode{});
        database.create(":model0", "sphere", SphereNode{});
        database.create(":model0", "box", BoxNode{glm::dvec3(0.5), glm::dvec3(1)});
        database.create(":model0", "mesh", polyhedronNode(icosphereMesh(2)));
        database.create(":model0", "small", polyhedronNode(cubeMesh()));
        database.create(":model0", "lamp", AreaLightNode{core::Rgbf(1), {0, 2, 0}, 1});
        for (int depth = 1; depth <= 4; ++depth) {
            const std::string model = "model" + std::to_string(depth);
            database.create(":", model, TransformNode{});
            for (const char* name : {"first", "second"}) {
                const std::string path = ":" + model + ":" + name;
                database.create(":" + model, name, TransformNode{});
                place(path, 2);
                database.createInstance(path, "instance", ":model" + std::to_string(depth - 1));
            }
        }
        const Scene scene = compile(database, ":model4", {});
        ASSERT_EQ(scene.instances.size(), 5 * 16u);
        expectSameHits(scene, rayCount(1000));
    }
}

// One mesh within another that is ten thousand times as large, as triangles of the same polyhedron and of two.
TEST(AcceleratorMesh, SmallInHuge) {
    for (const bool isOne : {false, true}) {
        PolygonMesh small = icosphereMesh(3), huge = icosphereMesh(1);
        for (glm::dvec3& v : small.vertices) v = v + glm::dvec3(30, 20, 10);
        for (glm::dvec3& v : huge.vertices) v *= 1e4;
        Database database;
        if (isOne) {
            const auto first = static_cast<int>(small.vertices.size());
            small.vertices.insert(small.vertices.end(), huge.vertices.begin(), huge.vertices.end());
            for (const std::vector<int>& face : huge.faces)
                small.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
        } else {
            database.create(":", "huge", polyhedronNode(huge));
        }
        database.create(":", "small", polyhedronNode(small));
        const Scene scene = compile(database, ":", {});
        SameHits same(scene);
        support::TestRandom random(11);
        for (int i = 0; i < rayCount(2000); ++i) {
            const core::Vec3f from(random.next() < 0.5 ? randomPoint(random, 0, 40) : randomPoint(random, -2e4, 2e4));
            const core::Vec3f to(glm::dvec3(30, 20, 10) + randomPoint(random, -2, 2));
            same.checkEnds({from, to - from}, random);
        }
        EXPECT_GT(same.hits(), 0);
        EXPECT_GT(same.misses(), 0);
    }
}

}  // namespace
}  // namespace gr
