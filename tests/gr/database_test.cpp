#include "gr/error_of.h"

#include <gmock/gmock.h>

namespace gr {
namespace {

std::vector<std::string> childNames(const Node& node) {
    std::vector<std::string> names;
    for (const Node* child = node.firstChild; child != nullptr; child = child->next) names.push_back(child->name);
    return names;
}

// :robot:arm:hand, :robot:leg and :table
class TreeTest : public testing::Test {
protected:
    TreeTest() {
        database.create(":", "robot", TransformNode{});
        database.create(":robot", "arm", TransformNode{});
        database.create(":robot:arm", "hand", SphereNode{});
        database.create(":robot", "leg", TransformNode{});
        database.create(":", "table", BoxNode{});
    }
    void expectUnknown(const std::string& path, const std::string& meant) {
        const std::string suggestion = meant.empty() ? "" : " (did you mean \"" + meant + "\"?)";
        expectError(
            database, [&] { database.find(path); },
            "NODE UNKNOWN [" + path + "] no such node \"" + path + "\"" + suggestion);
    }

    Database database;
};

TEST(Database, BeginsWithTheRootAlone) {
    const Database database;
    EXPECT_EQ(database.nodeCount(), 1u);
    const Node& root = database.find(":");
    EXPECT_EQ(root.path(), ":");
    EXPECT_EQ(root.parent, nullptr);
    EXPECT_EQ(root.firstChild, nullptr);
    EXPECT_EQ(nextInSubtree(&root, &root), nullptr);
}

TEST_F(TreeTest, FindsEveryNodeByItsPath) {
    EXPECT_EQ(database.nodeCount(), 6u);
    for (const char* path : {":", ":robot", ":robot:arm", ":robot:arm:hand", ":robot:leg", ":table"})
        EXPECT_EQ(database.find(path).path(), path);
    EXPECT_EQ(database.find(":robot:arm:hand").parent, &database.find(":robot:arm"));
}

TEST_F(TreeTest, CreateReturnsTheNewNode) {
    const Node& node = database.create(":robot:arm", "finger", SphereNode{{1, 2, 3}, 4});
    EXPECT_EQ(&node, &database.find(":robot:arm:finger"));
    EXPECT_EQ(node.name, "finger");
    EXPECT_EQ(std::get<SphereNode>(node.content).centre, glm::dvec3(1, 2, 3));
    EXPECT_EQ(std::get<SphereNode>(node.content).radius, 4);
    EXPECT_EQ(node.matrix, nullptr);
    EXPECT_EQ(node.material, nullptr);
}

TEST_F(TreeTest, AnyNodeMayHaveChildren) {
    EXPECT_EQ(database.create(":table", "vase", SphereNode{}).path(), ":table:vase");
}

TEST_F(TreeTest, TheSameNameMayStandUnderAnotherParent) {
    EXPECT_EQ(database.create(":robot:leg", "hand", SphereNode{}).path(), ":robot:leg:hand");
    EXPECT_NE(&database.find(":robot:leg:hand"), &database.find(":robot:arm:hand"));
}

TEST_F(TreeTest, ChildrenKeepTheOrderInWhichTheyWereMade) {
    for (const char* name : {"z", "a", "m"}) database.create(":robot", name, TransformNode{});
    EXPECT_THAT(childNames(database.find(":robot")), testing::ElementsAre("arm", "leg", "z", "a", "m"));
    EXPECT_EQ(database.find(":robot").lastChild, &database.find(":robot:m"));
    EXPECT_EQ(database.find(":robot:a").previous, &database.find(":robot:z"));
}

TEST_F(TreeTest, WalksASubtreeParentsFirst) {
    std::vector<std::string> names;
    const Node* top = &database.find(":robot");
    for (const Node* node = top; node != nullptr; node = nextInSubtree(node, top)) names.push_back(node->name);
    EXPECT_THAT(names, testing::ElementsAre("robot", "arm", "hand", "leg"));
}

TEST_F(TreeTest, UnknownPathSuggestsTheNearestSibling) {
    expectUnknown(":robott", ":robot");
    expectUnknown(":tabel", ":table");
    expectUnknown(":robot:arn", ":robot:arm");
    expectUnknown(":robot:arm:hnd", ":robot:arm:hand");
    expectUnknown(":moon", "");
    // What is spelled alike elsewhere is not a sibling.
    expectUnknown(":hand", "");
}

TEST_F(TreeTest, UnknownPathSuggestsTheWrongWordInTheMiddle) {
    expectUnknown(":robot:amr:hand", ":robot:arm:hand");
    expectUnknown(":robt:arm:hand", ":robot:arm:hand");
    expectUnknown(":robt", ":robot");
    expectUnknown(":moon:arm:hand", "");
}

TEST_F(TreeTest, UnknownPathSuggestsTheForgottenColon) {
    expectUnknown("robot", ":robot");
    expectUnknown("robot:arm:hand", ":robot:arm:hand");
    expectUnknown("robot:arn", ":robot:arm");
    expectUnknown("robt:arm", ":robot:arm");
}

TEST_F(TreeTest, UnknownPathSuggestsLeavingOutColonsTooMany) {
    expectUnknown(":robot:", ":robot");
    expectUnknown(":robot:arm:", ":robot:arm");
}

TEST_F(TreeTest, PathsThatAreNone) {
    expectUnknown("", "");
    expectUnknown("::", "");
    expectUnknown(" ", "");
    expectUnknown(":robot::arm", "");
    EXPECT_EQ(errorOf([&] { database.find(": robot"); }).rfind("NODE UNKNOWN [: robot] no such node \": robot\"", 0),
              0u);
}

TEST_F(TreeTest, EveryFunctionNamesTheUnknownNode) {
    const std::string unknown = "NODE UNKNOWN [:robot:arn] no such node \":robot:arn\" (did you mean \":robot:arm\"?)";
    const std::string path = ":robot:arn";
    database.addMaterial("gold", materials::Diffuse{});
    const auto expectUnknownIn = [&](auto&& action) { expectError(database, action, unknown); };
    expectUnknownIn([&] { database.create(path, "a", TransformNode{}); });
    expectUnknownIn([&] { database.createInstance(path, "a", ":table"); });
    expectUnknownIn([&] { database.createInstance(":", "a", path); });
    expectUnknownIn([&] { database.checkNew(path, "a"); });
    expectUnknownIn([&] { database.translate(path, {1, 0, 0}); });
    expectUnknownIn([&] { database.rotate(path, 0, 1); });
    expectUnknownIn([&] { database.scale(path, {0, 0, 0}, {2, 2, 2}); });
    expectUnknownIn([&] { database.setMaterial(path, "gold"); });
    expectUnknownIn([&] { database.remove(path); });
    expectUnknownIn([&] { (void)database.print(path); });
}

TEST_F(TreeTest, RefusesANameTwice) {
    const std::string exists = "NODE EXISTS [:robot:arm] node \":robot:arm\" already exists";
    expectError(
        database, [&] { database.create(":robot", "arm", SphereNode{}); }, exists);
    expectError(
        database, [&] { database.createInstance(":robot", "arm", ":table"); }, exists);
    expectError(
        database, [&] { database.checkNew(":robot", "arm"); }, exists);
    EXPECT_TRUE(std::holds_alternative<TransformNode>(database.find(":robot:arm").content));
    EXPECT_NO_THROW(database.checkNew(":robot", "tail"));
    EXPECT_EQ(database.nodeCount(), 6u);
}

TEST_F(TreeTest, RefusesNamesThatCouldNotBePartOfAPath) {
    const std::string why = ": a name holds neither \":\" nor white space";
    expectError(
        database, [&] { database.create(":", "", SphereNode{}); }, "NODE NAME [] a name must not be empty");
    using namespace std::string_literals;
    for (const std::string& name : {"a:b"s, ":"s, "a b"s, " "s, "a\t"s, "\nb"s, "a\r"s, "\v"s, "\f"s}) {
        const std::string expected = "NODE NAME [" + name + "] bad name \"" + name + "\"" + why;
        expectError(
            database, [&] { database.create(":", name, SphereNode{}); }, expected);
        expectError(
            database, [&] { database.createInstance(":", name, ":table"); }, expected);
        expectError(
            database, [&] { database.checkNew(":", name); }, expected);
    }
    // A message ends where a C string does.
    EXPECT_EQ(errorOf([&] { database.checkNew(":", "a\0b"s); }), "NODE NAME [a\0b] bad name \"a"s);
    EXPECT_EQ(database.create(":", "\xc3\xa4rm.-{}$", SphereNode{}).path(), ":\xc3\xa4rm.-{}$");
}

TEST_F(TreeTest, RemovesASubtree) {
    database.remove(":robot:arm");
    EXPECT_EQ(database.nodeCount(), 4u);
    EXPECT_EQ(database.print(":robot"), ":robot transform\n  leg transform");
    expectUnknown(":robot:arm:hand", "");
    EXPECT_EQ(database.find(":robot").firstChild, &database.find(":robot:leg"));
    EXPECT_EQ(database.find(":robot:leg").previous, nullptr);
    // The name is free again.
    EXPECT_EQ(database.create(":robot", "arm", SphereNode{}).path(), ":robot:arm");
    EXPECT_THAT(childNames(database.find(":robot")), testing::ElementsAre("leg", "arm"));
}

TEST(Database, RemovesTheFirstTheMiddleTheLastAndTheOnlyChild) {
    Database database;
    for (const char* name : {"a", "b", "c", "d"}) database.create(":", name, TransformNode{});
    database.remove(":b");
    EXPECT_THAT(childNames(database.find(":")), testing::ElementsAre("a", "c", "d"));
    database.remove(":d");
    EXPECT_THAT(childNames(database.find(":")), testing::ElementsAre("a", "c"));
    EXPECT_EQ(database.find(":").lastChild, &database.find(":c"));
    database.remove(":a");
    EXPECT_THAT(childNames(database.find(":")), testing::ElementsAre("c"));
    database.remove(":c");
    EXPECT_EQ(database.find(":").firstChild, nullptr);
    EXPECT_EQ(database.find(":").lastChild, nullptr);
    EXPECT_EQ(database.nodeCount(), 1u);
}

TEST_F(TreeTest, TheRootCannotBeRemoved) {
    expectError(
        database, [&] { database.remove(":"); },
        "NODE ROOT [:] the root \":\" cannot be deleted; gr_reset deletes everything");
}

TEST_F(TreeTest, MaterialsByName) {
    database.addMaterial("gold", materials::Diffuse{{0.9f, 0.7f, 0.2f}});
    database.addMaterial("silver", materials::Diffuse{{0.8f, 0.8f, 0.8f}});
    database.setMaterial(":robot", "gold");
    const NamedMaterial* gold = database.find(":robot").material;
    ASSERT_NE(gold, nullptr);
    EXPECT_EQ(gold->name, "gold");
    EXPECT_EQ(std::get<materials::Diffuse>(gold->material).reflectance.value, core::Rgbf(0.9f, 0.7f, 0.2f));

    expectError(
        database, [&] { database.setMaterial(":robot", "gld"); },
        "MATERIAL UNKNOWN [gld] no such material \"gld\" (did you mean \"gold\"?)");
    expectError(
        database, [&] { database.setMaterial(":robot", "wood"); }, "MATERIAL UNKNOWN [wood] no such material \"wood\"");
    expectError(
        database, [&] { database.addMaterial("gold", materials::Diffuse{}); },
        "MATERIAL EXISTS [gold] material \"gold\" already exists; -redefine changes it");
    expectError(
        database, [&] { database.addMaterial("", materials::Diffuse{}); }, "MATERIAL NAME [] a name must not be empty");
    EXPECT_EQ(std::get<materials::Diffuse>(gold->material).reflectance.value, core::Rgbf(0.9f, 0.7f, 0.2f));

    database.setMaterial(":robot", "silver");
    EXPECT_EQ(database.find(":robot").material->name, "silver");
    // Nodes point at materials: more of them leave those where they are.
    for (int i = 0; i < 1000; ++i) database.addMaterial("m" + std::to_string(i), materials::Diffuse{});
    EXPECT_EQ(gold->name, "gold");
    database.setMaterial(":table", "gold");
    EXPECT_EQ(database.find(":table").material, gold);
}

TEST_F(TreeTest, MaterialsMadeAgainByTheSameWordsStay) {
    EXPECT_EQ(database.addMaterial("gold", materials::Diffuse{{1, 0, 0}}, "diffuse red"), "gold");
    EXPECT_EQ(database.addMaterial("gold", materials::Diffuse{{1, 0, 0}}, "diffuse red"), "gold");
    expectError(
        database,
        [&] {
            database.addMaterial("gold", materials::Diffuse{{1, 0, 0}}, "diffuse #ff0000");
        },
        "MATERIAL EXISTS [gold] material \"gold\" already exists; -redefine changes it");
    database.redefineMaterial("gold", materials::Diffuse{{0, 1, 0}}, "diffuse lime");
    database.addMaterial("gold", materials::Diffuse{{0, 1, 0}}, "diffuse lime");
    expectError(
        database, [&] { database.redefineMaterial("gld", materials::Diffuse{}); },
        "MATERIAL UNKNOWN [gld] no such material \"gld\" (did you mean \"gold\"?)");
}

TEST_F(TreeTest, MaterialsAreRemovedWhenNoNodeHasThem) {
    database.addMaterial("gold", materials::Diffuse{});
    database.addMaterial("silver", materials::Diffuse{});
    for (const char* node : {":", ":table", ":robot"}) database.setMaterial(node, "gold");
    const auto remove = [&] { database.removeMaterial("gold"); };
    expectError(database, remove, "MATERIAL USED [gold] material \"gold\" is used by \":\"");
    database.setMaterial(":", "silver");
    EXPECT_NE(errorOf(remove), "");
    database.setMaterial(":table", "silver");
    database.setMaterial(":robot", "gold");
    expectError(database, remove, "MATERIAL USED [gold] material \"gold\" is used by \":robot\"");
    database.remove(":robot");
    remove();
    expectError(database, remove, "MATERIAL UNKNOWN [gold] no such material \"gold\"");
}

TEST_F(TreeTest, AutoIsTheNextFreeName) {
    database.create(":table", "leg2", BoxNode{});
    EXPECT_EQ(database.create(":table", "#auto", BoxNode{}, "leg").path(), ":table:leg1");
    EXPECT_EQ(database.create(":table", "#auto", BoxNode{}, "leg").path(), ":table:leg3");
    EXPECT_EQ(database.create(":table", "#auto", BoxNode{}, "foot").path(), ":table:foot1");
    EXPECT_EQ(database.create(":robot", "#auto", BoxNode{}, "leg").path(), ":robot:leg1");
    EXPECT_EQ(database.createInstance(":", "#auto", ":table").path(), ":instance1");
    expectError(
        database, [&] { database.createInstance(":table", "#auto", ":table"); },
        "NODE CYCLE [:table] an instance of \":table\" in \":table\" would hold itself");
    EXPECT_EQ(database.createInstance(":robot", "#auto", ":table").path(), ":robot:instance1");
    EXPECT_EQ(database.addMaterial("#auto", materials::Diffuse{}), "material1");
    EXPECT_EQ(database.addLight("#auto", PointLight{}), "light1");
}

TEST_F(TreeTest, PointLightsByName) {
    const auto lamp = [&] { return std::get<PointLight>(database.light("lamp")); };
    database.addLight("lamp", PointLight{{1, 2, 3}, {4, 5, 6}, {1, 0, 0}});
    EXPECT_EQ(lamp().position, core::Vec3f(1, 2, 3));
    EXPECT_EQ(lamp().intensity, core::Rgbf(4, 5, 6));
    expectError(
        database, [&] { database.light("lmap"); },
        "LIGHT UNKNOWN [lmap] no such light \"lmap\" (did you mean \"lamp\"?)");
    expectError(
        database, [&] { database.light("sun"); }, "LIGHT UNKNOWN [sun] no such light \"sun\"");
    expectError(
        database, [&] { database.addLight("lamp", {}); },
        "LIGHT EXISTS [lamp] light \"lamp\" already exists; -redefine changes it");
    expectError(
        database, [&] { database.addLight("", {}); }, "LIGHT NAME [] a name must not be empty");
    EXPECT_EQ(lamp().position, core::Vec3f(1, 2, 3));
}

TEST_F(TreeTest, ResetForgetsEverything) {
    database.addMaterial("gold", materials::Diffuse{});
    database.addLight("lamp", {});
    database.createInstance(":", "copy", ":robot");
    database.translate(":", {1, 2, 3});
    database.setMaterial(":", "gold");
    database.reset();
    EXPECT_EQ(database.nodeCount(), 1u);
    EXPECT_EQ(database.print(":"), ": transform");
    EXPECT_EQ(errorOf([&] { database.find(":robot"); }), "NODE UNKNOWN [:robot] no such node \":robot\"");
    EXPECT_EQ(errorOf([&] { database.light("lamp"); }), "LIGHT UNKNOWN [lamp] no such light \"lamp\"");
    EXPECT_EQ(errorOf([&] { database.setMaterial(":", "gold"); }), "MATERIAL UNKNOWN [gold] no such material \"gold\"");
    // All names are free again, and nothing is instanced any more.
    database.addMaterial("gold", materials::Diffuse{});
    database.addLight("lamp", {});
    database.create(":", "robot", TransformNode{});
    database.remove(":robot");
    EXPECT_EQ(database.nodeCount(), 1u);
    database.reset();
    database.reset();
    EXPECT_EQ(database.nodeCount(), 1u);
}

}  // namespace
}  // namespace gr
