#include "gr/error_of.h"

namespace gr {
namespace {

TEST(Print, TheEmptyScene) {
    EXPECT_EQ(Database().print(":"), ": transform");
}

TEST(Print, EveryKindOfNode) {
    Database database;
    database.create(":", "t", TransformNode{});
    database.create(":", "s", SphereNode{});
    database.create(":", "s2", SphereNode{{1, -2.5, 1e20}, 0.1});
    database.create(":", "b", BoxNode{});
    database.create(":", "b2", BoxNode{{-1, 0, 3}, {2, 0.25, 1e-7}});
    database.create(":", "light", AreaLightNode{{15, 0.1f, 0}, {0, 5, -0.5}, 1.5});
    MeshRepairs repairs;
    const PolygonMesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}};
    database.create(":", "p", PolyhedronNode{Polyhedron::make(square, repairs)});
    database.createInstance(":", "i", ":t");
    EXPECT_EQ(database.print(":"),
              ": transform\n"
              "  t transform\n"
              "  s sphere {0 0 0} 1\n"
              "  s2 sphere {1 -2.5 1e+20} 0.1\n"
              "  b box {0 0 0} {1 1 1}\n"
              "  b2 box {-1 0 3} {2 0.25 1e-07}\n"
              "  light area light {15 0.1 0} {0 5 -0.5} 1.5\n"
              "  p polyhedron of 2 triangles\n"
              "  i instance of :t");
}

TEST(Print, LightsThatHaveNamesBehindTheWholeTree) {
    Database database;
    database.create(":", "t", TransformNode{});
    database.addLight("moon", PointLight{{1, -2.5, 1e20}, {0.1f, 0, 3}, {0, 0.5f, 1}});
    database.addLight("bulb", PointLight{{0, 0, 0}, core::Rgbf(1), {1, 0, 0}});
    EXPECT_EQ(database.print(":"),
              ": transform\n"
              "  t transform\n"
              "bulb point light {0 0 0} {1 1 1} {1 0 0}\n"
              "moon point light {1 -2.5 1e+20} {0.1 0 3} {0 0.5 1}");
    EXPECT_EQ(database.print(":t"), ":t transform");
}

TEST(Print, IndentsByDepthAndComesBackUp) {
    Database database;
    database.create(":", "a", TransformNode{});
    database.create(":a", "b", TransformNode{});
    database.create(":a:b", "c", TransformNode{});
    database.create(":a:b:c", "d", SphereNode{});
    database.create(":a", "e", TransformNode{});
    database.create(":", "f", TransformNode{});
    database.create(":f", "g", TransformNode{});
    EXPECT_EQ(database.print(":"),
              ": transform\n"
              "  a transform\n"
              "    b transform\n"
              "      c transform\n"
              "        d sphere {0 0 0} 1\n"
              "    e transform\n"
              "  f transform\n"
              "    g transform");
    // A subtree begins with its whole path, and its siblings are no part of it.
    EXPECT_EQ(database.print(":a:b"),
              ":a:b transform\n"
              "  c transform\n"
              "    d sphere {0 0 0} 1");
    EXPECT_EQ(database.print(":f:g"), ":f:g transform");
}

TEST(Print, AnInstanceNamesItsTargetsWholePathAndDoesNotRepeatIt) {
    Database database;
    database.create(":", "a", TransformNode{});
    database.create(":a", "b", TransformNode{});
    database.create(":a:b", "c", SphereNode{});
    database.createInstance(":", "i", ":a:b");
    database.createInstance(":i", "j", ":a:b:c");
    EXPECT_EQ(database.print(":i"), ":i instance of :a:b\n  j instance of :a:b:c");
}

TEST(Print, MaterialThenMatrix) {
    Database database;
    database.create(":", "s", SphereNode{});
    database.addMaterial("gold", materials::Diffuse{});
    database.setMaterial(":s", "gold");
    EXPECT_EQ(database.print(":s"), ":s sphere {0 0 0} 1, material gold");
    database.translate(":s", {4, 5.5, -6});
    database.scale(":s", {0, 0, 0}, {1, 2, 3});
    EXPECT_EQ(database.print(":s"), ":s sphere {0 0 0} 1, material gold, matrix {1 0 0 4} {0 2 0 5.5} {0 0 3 -6}");
    database.translate(":", {0, 0, 1});
    EXPECT_EQ(database.print(":"),
              ": transform, matrix {1 0 0 0} {0 1 0 0} {0 0 1 1}\n"
              "  s sphere {0 0 0} 1, material gold, matrix {1 0 0 4} {0 2 0 5.5} {0 0 3 -6}");
}

// Rows as one writes them down: a point is a column to their right. A zero has no sign.
TEST(Print, MatrixRowByRow) {
    Database database;
    database.create(":", "n", TransformNode{});
    database.rotate(":n", 2, 90);
    database.translate(":n", {10, 20, 30});
    EXPECT_EQ(database.print(":n"), ":n transform, matrix {0 -1 0 -20} {1 0 0 10} {0 0 1 30}");
    database.create(":", "half", TransformNode{});
    database.rotate(":half", 1, 180);
    EXPECT_EQ(database.print(":half"), ":half transform, matrix {-1 0 0 0} {0 1 0 0} {0 0 -1 0}");
}

// Every number is printed so that it reads back as the same one.
TEST(Print, NumbersReadBackAsTheyWere) {
    Database database;
    const double third = 1.0 / 3;
    database.create(":", "s", SphereNode{{third, 0.1 + 0.2, 5e-324}, 1.7976931348623157e308});
    EXPECT_EQ(database.print(":s"),
              ":s sphere {0.3333333333333333 0.30000000000000004 5e-324} 1.7976931348623157e+308");
}

// 2000 levels, since a path that long is looked up for each of them.
TEST(Print, ADeepTreeNeedsNoDeepStack) {
    constexpr int depth = 2000;
    Database database;
    std::string path = ":";
    for (int i = 0; i < depth; ++i) path = database.create(path, "n", TransformNode{}).path();
    EXPECT_EQ(path.size(), 2u * depth);
    const std::string text = database.print(":");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), depth);
    EXPECT_TRUE(text.ends_with("\n" + std::string(2 * depth, ' ') + "n transform"));
    database.remove(":n");
    EXPECT_EQ(database.nodeCount(), 1u);
}

}  // namespace
}  // namespace gr
