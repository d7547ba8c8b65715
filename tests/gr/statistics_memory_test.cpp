// That the bytes which a database says it takes are those that are allocated. Each part of the sum was left out once,
// and a test failed.
#include "gr/bytes_in_use.h"
#include "gr/database/database.h"
#include "gr/mesh_text.h"
#include "gr/uv_sphere_mesh.h"

#include <gtest/gtest.h>

#ifdef GRSH_COUNTS_BYTES

namespace gr {
namespace {

// What `fill` adds to an empty database, as the statistics tell it and as the allocator does, within 3 %: it
// gives some things a few bytes more.
template<class Fill>
void expectTrueBytes(const Fill& fill) {
    const std::int64_t before = bytesInUse;
    Database database;
    fill(database);
    const std::int64_t allocated = bytesInUse - before;
    const DatabaseStatistics statistics = database.statistics();
    const double told = static_cast<double>(statistics.nodeBytes + statistics.meshBytes + statistics.materialBytes);
    EXPECT_NEAR(told, static_cast<double>(allocated), 0.03 * static_cast<double>(allocated));
}

std::string longName(int i) {
    return "aNameTooLongForAShortString" + std::to_string(i);
}

TEST(StatisticsMemory, OfNothing) {
    expectTrueBytes([](Database&) {});
    expectTrueBytes([](Database& database) { database.translate(":", {1, 2, 3}); });
}

TEST(StatisticsMemory, OfNodes) {
    constexpr int count = 20000;
    expectTrueBytes([](Database& database) {
        for (int i = 0; i < count; ++i) database.create(":", std::to_string(i), SphereNode{});
    });
    expectTrueBytes([](Database& database) {
        for (int i = 0; i < count; ++i) database.create(":", longName(i), TransformNode{});
    });
    expectTrueBytes([](Database& database) {
        for (int i = 0; i < count; ++i)
            database.translate(database.create(":", std::to_string(i), BoxNode{}).path(), {1, 2, 3});
    });
}

TEST(StatisticsMemory, OfNamesFound) {
    expectTrueBytes([](Database& database) {
        for (int i = 0; i < 5000; ++i)
            database.create(database.create(":", "#auto", TransformNode{}, "transform").path(), "#auto", SphereNode{},
                            "sphere");
    });
}

TEST(StatisticsMemory, OfInstances) {
    constexpr int count = 20000;
    expectTrueBytes([](Database& database) {
        database.create(":", "ball", SphereNode{});
        for (int i = 0; i < count; ++i) database.createInstance(":", std::to_string(i), ":ball");
    });
    expectTrueBytes([](Database& database) {
        for (int i = 0; i < count; ++i) {
            const std::string ball = database.create(":", "ball" + std::to_string(i), SphereNode{}).path();
            database.createInstance(":", std::to_string(i), ball);
        }
    });
}

TEST(StatisticsMemory, OfMeshes) {
    const MeshFolder folder;
    std::vector<std::string> files;
    for (int i = 0; i < 20; ++i) files.push_back(folder.write(longName(i) + ".obj", blockObj()));
    MeshRepairs repairs;
    expectTrueBytes([&](Database& database) {
        for (int i = 0; i < 1000; ++i) {
            const auto mesh = Polyhedron::make(uvSphereMesh(2, 3), repairs);
            for (const char* name : {"a", "b"}) database.create(":", name + std::to_string(i), PolyhedronNode{mesh});
        }
    });
    expectTrueBytes([&](Database& database) {
        const auto mesh = Polyhedron::make(uvSphereMesh(2, 3), repairs);
        for (int i = 0; i < 1000; ++i) database.create(":", std::to_string(i), PolyhedronNode{mesh, longName(i)});
    });
    expectTrueBytes([&](Database& database) {
        for (const std::string& file : files)
            database.create(":", std::to_string(&file - &files[0]),
                            PolyhedronNode{database.readMesh(file, file, repairs)});
    });
}

TEST(StatisticsMemory, OfMaterialsAndLights) {
    expectTrueBytes([](Database& database) {
        for (int i = 0; i < 1000; ++i) database.addMaterial(longName(i), {});
    });
    expectTrueBytes([](Database& database) {
        for (int i = 0; i < 1000; ++i) database.addMaterial(longName(i), {}, longName(i) + longName(i));
    });
    expectTrueBytes([](Database& database) {
        for (int i = 0; i < 1000; ++i) database.addLight(longName(i), {});
    });
}

}  // namespace
}  // namespace gr

#endif
