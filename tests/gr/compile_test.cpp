#include "gr/error_of.h"
#include "gr/scene.h"

#include <gmock/gmock.h>
#include <glm/ext/matrix_transform.hpp>

namespace gr {
namespace {

glm::dvec3 placeOf(const Instance& instance) {
    return instance.place.worldFromObject().translation;
}

// Where the unit spheres of a scene came to be, in its order.
std::vector<double> xOf(const Scene& scene) {
    std::vector<double> xs;
    for (const Instance& instance : scene.instances) xs.push_back(placeOf(instance).x);
    return xs;
}

core::Rgbf reflectanceOf(const Scene& scene, std::size_t instance) {
    return std::get<materials::Diffuse>(scene.materials.at(scene.instances.at(instance).material)).reflectance.value;
}

void expectMatrix(const core::Transform& map, const glm::dmat4& expected) {
    const core::Vec3f columns[] = {map.x, map.y, map.z, map.translation};
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            EXPECT_NEAR(columns[column][row], expected[column][row], 1e-6 * (1 + std::abs(expected[column][row])))
                << "row " << row << ", column " << column;
}

TEST(Compile, AnEmptySceneHasNothing) {
    const Scene scene = compile(Database(), ":", {});
    EXPECT_TRUE(scene.instances.empty());
    EXPECT_EQ(scene.lights.size(), 0u);
    EXPECT_TRUE(scene.polyhedra.empty());
}

TEST(Compile, SizesAndPlacesBecomePartOfTheTransform) {
    Database database;
    database.create(":", "s", SphereNode{{1, 2, 3}, 4});
    database.create(":", "b", BoxNode{{1, 2, 3}, {4, 5, 6}});
    database.create(":", "l", AreaLightNode{{1, 1, 1}, {7, 8, 9}, 2});
    const Scene scene = compile(database, ":", {});
    ASSERT_EQ(scene.instances.size(), 3u);
    const auto placed = [](const glm::dvec3& at, const glm::dvec3& size) {
        return glm::scale(glm::translate(glm::dmat4(1), at), size);
    };
    const glm::dmat4 expected[] = {placed({1, 2, 3}, glm::dvec3(4)), placed({1, 2, 3}, {4, 5, 6}),
                                   placed({7, 8, 9}, glm::dvec3(2))};
    for (int i = 0; i < 3; ++i) {
        expectMatrix(scene.instances[i].place.worldFromObject(), expected[i]);
        expectMatrix(scene.instances[i].place.objectFromWorld(), glm::inverse(expected[i]));
    }
    EXPECT_TRUE(std::holds_alternative<Sphere>(scene.instances[0].shape));
    EXPECT_TRUE(std::holds_alternative<Box>(scene.instances[1].shape));
    EXPECT_TRUE(std::holds_alternative<Square>(scene.instances[2].shape));
}

TEST(Compile, MatricesMultiplyFromTheRootDown) {
    Database database;
    database.create(":", "a", TransformNode{});
    database.create(":a", "s", SphereNode{});
    database.scale(":", {0, 0, 0}, {2, 2, 2});
    database.rotate(":a", 2, 90);
    database.translate(":a:s", {1, 0, 0});
    const Scene scene = compile(database, ":", {});
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(placeOf(scene.instances[0]), glm::dvec3(0, 2, 0));
}

TEST(Compile, ANodesChildrenMoveWithItAlsoWhenItIsALeaf) {
    Database database;
    database.create(":", "s", SphereNode{{5, 0, 0}, 3});
    database.create(":s", "child", SphereNode{});
    database.translate(":s", {0, 1, 0});
    const Scene scene = compile(database, ":", {});
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(placeOf(scene.instances[0]), glm::dvec3(5, 1, 0));
    // A sphere's centre and radius are its own, not its children's.
    EXPECT_EQ(placeOf(scene.instances[1]), glm::dvec3(0, 1, 0));
    EXPECT_EQ(scene.instances[1].place.worldFromObject().x, core::Vec3f(1, 0, 0));
}

TEST(Compile, TheRenderedNodesOwnMatrixCountsThoseAboveItDoNot) {
    Database database;
    database.create(":", "a", TransformNode{});
    database.create(":a", "b", TransformNode{});
    database.create(":a:b", "s", SphereNode{});
    database.create(":a", "beside", SphereNode{});
    database.translate(":", {1000, 0, 0});
    database.translate(":a", {100, 0, 0});
    database.translate(":a:b", {10, 0, 0});
    database.translate(":a:b:s", {1, 0, 0});
    EXPECT_THAT(xOf(compile(database, ":", {})), testing::ElementsAre(1111, 1100));
    EXPECT_THAT(xOf(compile(database, ":a", {})), testing::ElementsAre(111, 100));
    EXPECT_THAT(xOf(compile(database, ":a:b", {})), testing::ElementsAre(11));
    EXPECT_THAT(xOf(compile(database, ":a:b:s", {})), testing::ElementsAre(1));
}

TEST(Compile, AnInstancesMatrixComesBeforeItsTargets) {
    Database database;
    database.create(":", "above", TransformNode{});
    database.translate(":above", {0, 0, 50});
    database.create(":above", "target", SphereNode{});
    database.translate(":above:target", {1, 0, 0});
    database.create(":", "shown", TransformNode{});
    database.createInstance(":shown", "i", ":above:target");
    database.rotate(":shown:i", 2, 90);
    database.scale(":shown", {0, 0, 0}, {1, 3, 1});
    const Scene scene = compile(database, ":shown", {});
    ASSERT_EQ(scene.instances.size(), 1u);
    // The target's own translation is turned, then stretched; what is above the target stays behind.
    EXPECT_EQ(placeOf(scene.instances[0]), glm::dvec3(0, 3, 0));
}

TEST(Compile, NestedInstancesMultiplyTheirMatrices) {
    Database database;
    database.create(":", "ball", SphereNode{});
    database.create(":", "pair", TransformNode{});
    for (const double x : {1, 2}) {
        const Node& i = database.createInstance(":pair", "i" + std::to_string(int(x)), ":ball");
        database.translate(i.path(), {x, 0, 0});
    }
    database.create(":", "four", TransformNode{});
    for (const double x : {10, 20}) {
        const Node& i = database.createInstance(":four", "i" + std::to_string(int(x)), ":pair");
        database.translate(i.path(), {x, 0, 0});
    }
    EXPECT_THAT(xOf(compile(database, ":four", {})), testing::ElementsAre(11, 12, 21, 22));
    EXPECT_THAT(xOf(compile(database, ":four:i20", {})), testing::ElementsAre(21, 22));
}

TEST(Compile, OrderIsTheTreesTargetsBeforeTheInstancesOwnChildren) {
    Database database;
    const auto addBall = [&](const std::string& parent, const std::string& name, double x) {
        database.create(parent, name, SphereNode{{x, 0, 0}, 1});
    };
    database.create(":", "target", TransformNode{});
    addBall(":target", "a", 1);
    addBall(":target:a", "b", 2);
    addBall(":target", "c", 3);
    database.create(":", "shown", TransformNode{});
    addBall(":shown", "first", 4);
    database.createInstance(":shown", "i", ":target");
    addBall(":shown:i", "child", 5);
    addBall(":shown", "last", 6);
    EXPECT_THAT(xOf(compile(database, ":shown", {})), testing::ElementsAre(4, 1, 2, 3, 5, 6));
    EXPECT_THAT(xOf(compile(database, ":", {})), testing::ElementsAre(1, 2, 3, 4, 1, 2, 3, 5, 6));
}

TEST(Compile, TheNearestAncestorsMaterialHolds) {
    Database database;
    database.addMaterial("red", materials::Diffuse{{1, 0, 0}});
    database.addMaterial("green", materials::Diffuse{{0, 1, 0}});
    database.create(":", "plain", SphereNode{});
    database.create(":", "a", TransformNode{});
    database.create(":a", "inherits", SphereNode{});
    database.create(":a", "own", SphereNode{});
    database.create(":a:own", "below", SphereNode{});
    database.setMaterial(":a", "red");
    database.setMaterial(":a:own", "green");
    const Scene scene = compile(database, ":", {});
    ASSERT_EQ(scene.instances.size(), 4u);
    EXPECT_EQ(reflectanceOf(scene, 0), core::Rgbf(0.5f));  // nobody's: the default
    EXPECT_EQ(reflectanceOf(scene, 1), core::Rgbf(1, 0, 0));
    EXPECT_EQ(reflectanceOf(scene, 2), core::Rgbf(0, 1, 0));
    EXPECT_EQ(reflectanceOf(scene, 3), core::Rgbf(0, 1, 0));
    EXPECT_EQ(scene.materials.size(), 3u);
}

// Materials, like matrices, are those of the rendered node and what is below it.
TEST(Compile, AMaterialAboveTheRenderedNodeStaysBehind) {
    Database database;
    database.addMaterial("red", materials::Diffuse{{1, 0, 0}});
    database.create(":", "a", TransformNode{});
    database.create(":a", "s", SphereNode{});
    database.setMaterial(":", "red");
    EXPECT_EQ(reflectanceOf(compile(database, ":", {}), 0), core::Rgbf(1, 0, 0));
    EXPECT_EQ(reflectanceOf(compile(database, ":a", {}), 0), core::Rgbf(0.5f));
    database.setMaterial(":a", "red");
    EXPECT_EQ(reflectanceOf(compile(database, ":a", {}), 0), core::Rgbf(1, 0, 0));
}

TEST(Compile, AMaterialIsInheritedAlongTheInstancesPath) {
    Database database;
    database.addMaterial("red", materials::Diffuse{{1, 0, 0}});
    database.addMaterial("green", materials::Diffuse{{0, 1, 0}});
    database.addMaterial("blue", materials::Diffuse{{0, 0, 1}});
    database.create(":", "hidden", TransformNode{});
    database.setMaterial(":hidden", "blue");
    database.create(":hidden", "t", TransformNode{});
    database.create(":hidden:t", "plain", SphereNode{});
    database.create(":hidden:t", "green", SphereNode{});
    database.setMaterial(":hidden:t:green", "green");
    database.create(":", "shown", TransformNode{});
    database.createInstance(":shown", "grey", ":hidden:t");
    database.create(":shown", "group", TransformNode{});
    database.setMaterial(":shown:group", "red");
    database.createInstance(":shown:group", "red", ":hidden:t");
    database.createInstance(":shown:group", "blue", ":hidden:t");
    database.setMaterial(":shown:group:blue", "blue");

    const Scene scene = compile(database, ":shown", {});
    ASSERT_EQ(scene.instances.size(), 6u);
    EXPECT_EQ(reflectanceOf(scene, 0), core::Rgbf(0.5f));  // not the blue above the target
    EXPECT_EQ(reflectanceOf(scene, 2), core::Rgbf(1, 0, 0));
    EXPECT_EQ(reflectanceOf(scene, 4), core::Rgbf(0, 0, 1));
    for (const std::size_t own : {1, 3, 5}) EXPECT_EQ(reflectanceOf(scene, own), core::Rgbf(0, 1, 0));

    database.setMaterial(":hidden:t", "green");  // the target's own comes along
    EXPECT_EQ(reflectanceOf(compile(database, ":shown", {}), 2), core::Rgbf(0, 1, 0));
}

TEST(Compile, InstancesShareOnePolyhedron) {
    Database database;
    MeshRepairs repairs;
    const PolygonMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const auto polyhedron = Polyhedron::make(triangle, repairs);
    database.create(":", "p", PolyhedronNode{polyhedron});
    database.createInstance(":", "i", ":p");
    const Scene scene = compile(database, ":", {});
    ASSERT_EQ(scene.instances.size(), 2u);
    ASSERT_EQ(scene.polyhedra.size(), 1u);
    EXPECT_EQ(std::get<const Polyhedron*>(scene.instances[0].shape), polyhedron.get());
    EXPECT_EQ(std::get<const Polyhedron*>(scene.instances[1].shape), polyhedron.get());
}

TEST(Compile, TheSceneOutlivesWhatItWasMadeFrom) {
    Database database;
    MeshRepairs repairs;
    const PolygonMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    database.create(":", "p", PolyhedronNode{Polyhedron::make(triangle, repairs)});
    const Scene scene = compile(database, ":", {});
    database.reset();
    EXPECT_EQ(std::get<const Polyhedron*>(scene.instances.at(0).shape)->vertex(0, 1), core::Vec3f(1, 0, 0));
}

TEST(Compile, NamedPointLightsInTheOrderAskedFor) {
    Database database;
    for (const int i : {1, 2, 3}) database.addLight("l" + std::to_string(i), PointLight{core::Vec3f(i), {}, {1, 0, 0}});
    database.translate(":", {9, 9, 9});  // they stand outside the graph
    const std::vector<std::string> names{"l3", "l1"};
    const Scene scene = compile(database, ":", names);
    const std::vector<PointLight>& lights = scene.lights.of<PointLight>();
    ASSERT_EQ(lights.size(), 2u);
    EXPECT_EQ(lights[0].position, core::Vec3f(3));
    EXPECT_EQ(lights[1].position, core::Vec3f(1));
}

TEST(Compile, UnknownNodesAndLights) {
    Database database;
    database.create(":", "room", TransformNode{});
    database.addLight("lamp", {});
    const std::vector<std::string> names{"lamp", "lmap"};
    EXPECT_EQ(errorOf([&] { compile(database, ":rom", {}); }),
              "NODE UNKNOWN [:rom] no such node \":rom\" (did you mean \":room\"?)");
    EXPECT_EQ(errorOf([&] { compile(database, ":room", names); }),
              "LIGHT UNKNOWN [lmap] no such light \"lmap\" (did you mean \"lamp\"?)");
}

}  // namespace
}  // namespace gr
