// What a database says it holds. That its bytes are true is tested in database_memory_test.cpp.
#include "gr/database/database.h"
#include "gr/uv_sphere_mesh.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

template<class Node>
std::size_t count(const DatabaseStatistics& statistics) {
    return statistics.nodes[NodeContent(Node{}).index()];
}

TEST(Statistics, OfNothing) {
    const DatabaseStatistics statistics = Database().statistics();
    EXPECT_EQ(count<TransformNode>(statistics) + count<SphereNode>(statistics) + count<BoxNode>(statistics) +
                  count<PolyhedronNode>(statistics),
              0u);
    EXPECT_EQ(
        count<AreaLightNode>(statistics) + count<InstanceNode>(statistics) + statistics.meshes + statistics.triangles,
        0u);
    EXPECT_EQ(statistics.materials + statistics.lights, 0u);
    EXPECT_EQ(statistics.objects, 0);
    EXPECT_EQ(statistics.nodeBytes + statistics.meshBytes + statistics.materialBytes, 0u);
}

TEST(Statistics, EveryKindIsCountedUnderItsName) {
    Database database;
    MeshRepairs repairs;
    const auto first = Polyhedron::make(uvSphereMesh(4, 5), repairs);
    const auto second = Polyhedron::make(uvSphereMesh(3, 4), repairs);
    const auto make = [&](const NodeContent& content, int count) {
        for (int i = 0; i < count; ++i) database.create(":", std::to_string(database.nodeCount()), content);
    };
    make(TransformNode{}, 1);
    make(SphereNode{}, 2);
    make(BoxNode{}, 3);
    make(PolyhedronNode{first}, 3);
    make(PolyhedronNode{second}, 1);
    make(AreaLightNode{}, 5);
    for (int i = 0; i < 6; ++i) database.createInstance(":", "copy" + std::to_string(i), ":2");
    for (int i = 0; i < 7; ++i) database.addMaterial(std::to_string(i), {});
    for (int i = 0; i < 8; ++i) database.addLight(std::to_string(i), {});

    const DatabaseStatistics statistics = database.statistics();
    EXPECT_EQ(count<TransformNode>(statistics), 1u);
    EXPECT_EQ(count<SphereNode>(statistics), 2u);
    EXPECT_EQ(count<BoxNode>(statistics), 3u);
    EXPECT_EQ(count<PolyhedronNode>(statistics), 4u);
    EXPECT_EQ(count<AreaLightNode>(statistics), 5u);
    EXPECT_EQ(count<InstanceNode>(statistics), 6u);
    EXPECT_EQ(statistics.materials, 7u);
    EXPECT_EQ(statistics.lights, 8u);
    EXPECT_EQ(statistics.meshes, 2u);
    EXPECT_EQ(statistics.triangles, first->triangleCount() + second->triangleCount());
    EXPECT_EQ(statistics.objects, 2 + 3 + 4 + 5 + 6);
}

TEST(Statistics, ObjectsAreThoseOfInstancesSpreadOut) {
    Database database;
    database.create(":", "0", TransformNode{});
    database.create(":0", "ball", SphereNode{});
    // Each holds the one before twice.
    for (int i = 1; i <= 100; ++i) {
        const std::string path = database.create(":", std::to_string(i), TransformNode{}).path();
        for (const char* name : {"a", "b"}) database.createInstance(path, name, ":" + std::to_string(i - 1));
    }
    EXPECT_EQ(database.statistics().objects, std::exp2(101) - 1);
    EXPECT_EQ(count<SphereNode>(database.statistics()), 1u);
    database.remove(":100");
    EXPECT_EQ(database.statistics().objects, std::exp2(100) - 1);
}

TEST(Statistics, WhatIsRemovedIsNotCounted) {
    Database database;
    MeshRepairs repairs;
    database.create(":", "group", TransformNode{});
    database.create(":group", "ball", SphereNode{});
    database.create(":", "mesh", PolyhedronNode{Polyhedron::make(uvSphereMesh(4, 5), repairs)});
    database.addMaterial("clay", {});
    database.remove(":group");
    EXPECT_EQ(count<TransformNode>(database.statistics()) + count<SphereNode>(database.statistics()), 0u);
    EXPECT_EQ(database.statistics().objects, 1);
    database.reset();
    EXPECT_EQ(database.statistics().objects, 0);
    EXPECT_EQ(database.statistics().meshes + database.statistics().triangles + database.statistics().materials, 0u);
    EXPECT_EQ(database.statistics().meshBytes, 0u);
}

}  // namespace
}  // namespace gr
