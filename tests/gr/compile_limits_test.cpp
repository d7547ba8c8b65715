// Scenes too large, too deep or too far away.
#include "gr/error_of.h"
#include "gr/scene.h"

#include <gmock/gmock.h>
#include <chrono>

namespace gr {
namespace {

// Each level, ":0" to ":<levels>", holds the one below twice.
void addDoublings(Database& database, int levels) {
    database.create(":", "0", SphereNode{});
    for (int i = 1; i <= levels; ++i) {
        const std::string level = std::to_string(i), below = ":" + std::to_string(i - 1);
        database.create(":", level, TransformNode{});
        database.createInstance(":" + level, "a", below);
        database.createInstance(":" + level, "b", below);
    }
}

TEST(CompileLimits, NestedInstancesMultiply) {
    Database database;
    addDoublings(database, 10);
    EXPECT_EQ(compile(database, ":10", {}).instances.size(), 1024u);
}

TEST(CompileLimits, WhatInstancesMultiplyBeyondMemoryIsRefused) {
    Database database;
    addDoublings(database, 60);
    const std::string error = errorOf([&] { compile(database, ":60", {}); });
    // 2^60 spheres, with the instances and inner nodes that hold them.
    EXPECT_THAT(error, testing::MatchesRegex("SCENE MEMORY \\[:60\\] \":60\" has [0-9.e+]+ objects when its instances "
                                             "are spread out, which takes [0-9]+ EB of memory; "
                                             "[0-9.]+ [KMGT]B are free"));
    EXPECT_EQ(database.nodeCount(), 182u);
}

// Counting must not walk the same target once for each of its instances: 10^10 steps here.
TEST(CompileLimits, ALargeTargetUsedOftenIsRefusedAtOnce) {
    constexpr int count = 100000;
    Database database;
    database.create(":", "target", TransformNode{});
    database.create(":", "shown", TransformNode{});
    for (int i = 0; i < count; ++i) database.create(":target", std::to_string(i), SphereNode{});
    for (int i = 0; i < count; ++i) database.createInstance(":shown", std::to_string(i), ":target");
    const auto start = std::chrono::steady_clock::now();
    const std::string error = errorOf([&] { compile(database, ":shown", {}); });
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(error.rfind("SCENE MEMORY [:shown] \":shown\" has ", 0), 0u) << error;
    EXPECT_LT(seconds.count(), 10);
}

// 2000 levels, since a path that long is looked up for each of them.
TEST(CompileLimits, ADeepTreeNeedsNoDeepStack) {
    Database database;
    std::string path = ":";
    for (int i = 0; i < 2000; ++i) {
        path = database.create(path, "n", TransformNode{}).path();
        database.translate(path, {1, 0, 0});
    }
    database.create(path, "s", SphereNode{});
    const Scene scene = compile(database, ":", {});
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].place.worldFromObject().translation, core::Vec3f(2000, 0, 0));
}

// Instances nest deeper with short paths.
TEST(CompileLimits, DeeplyNestedInstancesNeedNoDeepStack) {
    constexpr int depth = 100000;
    Database database;
    database.create(":", "0", SphereNode{});
    for (int i = 1; i <= depth; ++i) {
        const std::string level = std::to_string(i);
        database.create(":", level, TransformNode{});
        database.createInstance(":" + level, "i", ":" + std::to_string(i - 1));
        database.translate(":" + level, {1, 0, 0});
    }
    const Scene scene = compile(database, ":" + std::to_string(depth), {});
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].place.worldFromObject().translation, core::Vec3f(depth, 0, 0));
    EXPECT_EQ(errorOf([&] { database.createInstance(":0", "i", ":" + std::to_string(depth)); }),
              "NODE CYCLE [:100000] an instance of \":100000\" in \":0\" would hold itself");
}

TEST(CompileLimits, WhatSinglePrecisionCannotHoldIsRefused) {
    const auto errorFor = [](const NodeContent& content, auto&& transform) {
        Database database;
        database.create(":", "group", TransformNode{});
        database.create(":group", "thing", content);
        transform(database);
        return errorOf([&] { compile(database, ":", {}); });
    };
    const auto none = [](Database&) {};
    const std::string refused =
        "SCENE RANGE [:group:thing] \":group:thing\" is too large, too small or too far away to be rendered";
    EXPECT_EQ(errorFor(SphereNode{{0, 0, 0}, 1e19}, none), refused);
    EXPECT_EQ(errorFor(SphereNode{{0, 0, 0}, 1e-19}, none), refused);
    EXPECT_EQ(errorFor(SphereNode{{0, 1e19, 0}, 1}, none), refused);
    EXPECT_EQ(errorFor(BoxNode{{0, 0, 0}, {1, 1, 1e-60}}, none), refused);
    EXPECT_EQ(errorFor(AreaLightNode{{1, 1, 1}, {0, 0, 0}, 1e30}, none), refused);
    EXPECT_EQ(errorFor(SphereNode{}, [](Database& d) { d.scale(":group", {0, 0, 0}, glm::dvec3(1e-20)); }), refused);
    EXPECT_EQ(errorFor(SphereNode{},
                       [](Database& d) {
                           for (const char* node : {":group", ":group:thing"})
                               d.scale(node, {0, 0, 0}, glm::dvec3(1e10));
                       }),
              refused);
    EXPECT_EQ(errorFor(SphereNode{},
                       [](Database& d) {
                           for (const char* node : {":group", ":group:thing"}) d.scale(node, {0, 0, 0}, {1e-200, 1, 1});
                       }),
              refused);
    EXPECT_EQ(errorFor(SphereNode{{1e17, 0, 0}, 1e17}, none), "no error");
    EXPECT_EQ(errorFor(SphereNode{{0, 0, 0}, 1e-17}, none), "no error");
}

}  // namespace
}  // namespace gr
