// What is said of shapes that are too small for how far away they are.
#include "gr/database/database.h"
#include "gr/random_shapes.h"
#include "gr/scene.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using Texts = std::vector<std::string>;

Texts warningsOf(const std::function<void(Database&)>& fill) {
    Database database;
    fill(database);
    return compile(database, ":", {}, Origin::isNear).warnings;
}

// With a ball at the origin, so that the scene is as large as it is far away.
Texts warningsBesideABall(const NodeContent& content) {
    return warningsOf([&](Database& database) {
        database.create(":", "near", SphereNode{{0, 0, 0}, 1});
        database.create(":", "s", content);
    });
}

TEST(FarPlaces, AreToldByNameAndByHowMuchTheyAreRounded) {
    EXPECT_EQ(warningsBesideABall(SphereNode{{5000000.25, 0, 0}, 0.3}),
              Texts{"sphere \":s\" lies 5e+06 from the origin, where single precision rounds places to 0.5"});
    EXPECT_EQ(warningsBesideABall(BoxNode{{0, 0, -4000}, {0.001, 0.002, 0.003}}),
              Texts{"box \":s\" lies 4e+03 from the origin, where single precision rounds places to 0.00024"});
    PolygonMesh mesh = cubeMesh();
    for (glm::dvec3& v : mesh.vertices) v = v * 0.3 + glm::dvec3(5e6, 0, 0);
    EXPECT_EQ(warningsBesideABall(polyhedronNode(mesh)),
              Texts{"polyhedron \":s\" lies 5e+06 from the origin, where single precision rounds places to 0.5"});
}

TEST(FarPlaces, MayBeLargeForHowFarTheyAreAway) {
    EXPECT_EQ(warningsBesideABall(SphereNode{{5000000.25, 0, 0}, 30}), Texts());
    EXPECT_EQ(warningsBesideABall(BoxNode{{5e6, 0, 0}, {1e-3, 1e-3, 100}}), Texts()) << "large along one axis";
    EXPECT_EQ(warningsBesideABall(PlaneNode{{5e6, 0, 0}}), Texts()) << "endless";
    // 2^-24 of the place, against a hundredth of the size: just less, just more.
    EXPECT_EQ(warningsBesideABall(SphereNode{{8191, 0, 0}, 0.025}), Texts());
    EXPECT_EQ(warningsBesideABall(SphereNode{{8193, 0, 0}, 0.025}).size(), 1u);
}

TEST(FarPlaces, AreNotFarWithNothingElseAround) {
    EXPECT_EQ(warningsOf([](Database& database) {
                  database.create(":", "s", SphereNode{{5000000.25, 0, 0}, 0.3});
              }),
              Texts());
    EXPECT_EQ(
        warningsOf([](Database& database) {
            database.create(":", "a", SphereNode{{1e9, 0, 0}, 1});
            database.create(":", "s", SphereNode{{1e9 + 2000, 0, 0}, 1e-3});
        }),
        Texts{"sphere \":s\" lies 1e+03 from the scene's middle, where single precision rounds places to 6.1e-05"});
}

TEST(FarPlaces, AreCountedAndTheWorstOneIsNamed) {
    EXPECT_EQ(warningsOf([](Database& database) {
                  database.create(":", "near", SphereNode{{0, 0, 0}, 1});
                  database.create(":", "a", SphereNode{{5e6, 0, 0}, 0.3});
                  database.create(":", "b", SphereNode{{5e6, 0, 0}, 0.003});
                  database.create(":", "c", SphereNode{{-5e6, 0, 0}, 0.3});
              }),
              Texts{"sphere \":b\" lies 5e+06 from the origin, where single precision rounds places to 0.5; 2 more are "
                    "as far away for their size"});
}

TEST(FarPlaces, CountTransforms) {
    EXPECT_EQ(warningsOf([](Database& database) {
                  database.create(":", "near", SphereNode{{0, 0, 0}, 1});
                  database.create(":", "s", SphereNode{{0, 0, 0}, 3});
                  database.translate(":s", {0, 5e6, 0});
                  database.scale(":s", {0, 0, 0}, {0.1, 0.1, 0.1});
              }),
              Texts{"sphere \":s\" lies 5e+06 from the origin, where single precision rounds places to 0.5"});
}

}  // namespace
}  // namespace gr
