#include "gr/error_of.h"

namespace gr {
namespace {

std::string cycle(const std::string& target, const std::string& parent) {
    return "NODE CYCLE [" + target + "] an instance of \"" + target + "\" in \"" + parent + "\" would hold itself";
}

std::string instanced(const std::string& node, const std::string& instance) {
    return "NODE INSTANCED [" + node + "] \"" + node + "\" is used by the instance \"" + instance + "\"";
}

TEST(Instance, StandsForItsTarget) {
    Database database;
    const Node& ball = database.create(":", "ball", SphereNode{});
    database.create(":", "group", TransformNode{});
    const Node& copy = database.createInstance(":group", "copy", ":ball");
    EXPECT_EQ(copy.path(), ":group:copy");
    EXPECT_EQ(std::get<InstanceNode>(copy.content).target, &ball);
    EXPECT_EQ(&database.find(":group:copy"), &copy);
    // The target's children are not found below the instance.
    database.create(":ball", "spot", SphereNode{});
    expectError(
        database, [&] { database.find(":group:copy:spot"); },
        "NODE UNKNOWN [:group:copy:spot] no such node \":group:copy:spot\"");
}

// The parent is looked at first, then the name, then the target: the order of the words.
TEST(Instance, TheFirstWrongWordIsNamed) {
    Database database;
    database.create(":", "arm", TransformNode{});
    const auto unknown = [](const std::string& path) {
        return "NODE UNKNOWN [" + path + "] no such node \"" + path + "\" (did you mean \":arm\"?)";
    };
    expectError(
        database, [&] { database.createInstance(":arn", "", ":amr"); }, unknown(":arn"));
    expectError(
        database, [&] { database.createInstance(":", "", ":amr"); }, "NODE NAME [] a name must not be empty");
    expectError(
        database, [&] { database.createInstance(":", "arm", ":amr"); },
        "NODE EXISTS [:arm] node \":arm\" already exists");
    expectError(
        database, [&] { database.createInstance(":", "a", ":amr"); }, unknown(":amr"));
}

TEST(Instance, RefusesToHoldItselfDirectly) {
    Database database;
    database.create(":", "a", TransformNode{});
    database.create(":a", "b", TransformNode{});
    database.create(":a:b", "c", TransformNode{});
    expectError(
        database, [&] { database.createInstance(":a", "i", ":a"); }, cycle(":a", ":a"));
    expectError(
        database, [&] { database.createInstance(":a:b:c", "i", ":a"); }, cycle(":a", ":a:b:c"));
    expectError(
        database, [&] { database.createInstance(":", "i", ":"); }, cycle(":", ":"));
    expectError(
        database, [&] { database.createInstance(":a:b", "i", ":"); }, cycle(":", ":a:b"));
    // A sibling, or what lies further down, is none of the things that hold the parent.
    EXPECT_NO_THROW(database.createInstance(":a", "i", ":a:b"));
    EXPECT_NO_THROW(database.createInstance(":", "i", ":a"));
}

TEST(Instance, RefusesToHoldItselfThroughOthers) {
    Database database;
    for (const char* name : {"a", "b", "c"}) database.create(":", name, TransformNode{});
    database.createInstance(":a", "toB", ":b");
    database.createInstance(":b", "toC", ":c");
    expectError(
        database, [&] { database.createInstance(":c", "i", ":a"); }, cycle(":a", ":c"));
    expectError(
        database, [&] { database.createInstance(":c", "i", ":b"); }, cycle(":b", ":c"));
    EXPECT_NO_THROW(database.createInstance(":a", "toC", ":c"));
}

TEST(Instance, RefusesToHoldItselfThroughChildrenMadeLater) {
    Database database;
    database.create(":", "a", TransformNode{});
    database.create(":", "b", TransformNode{});
    database.createInstance(":b", "toA", ":a");
    // What is put below the target later is part of the instance too, also below an instance node itself.
    database.create(":a", "later", TransformNode{});
    database.create(":a:later", "deep", TransformNode{});
    expectError(
        database, [&] { database.createInstance(":a:later:deep", "i", ":b"); }, cycle(":b", ":a:later:deep"));
    database.create(":b:toA", "below", TransformNode{});
    expectError(
        database, [&] { database.createInstance(":b:toA:below", "i", ":b"); }, cycle(":b", ":b:toA:below"));
    expectError(
        database, [&] { database.createInstance(":b:toA", "i", ":b:toA"); }, cycle(":b:toA", ":b:toA"));
}

TEST(Instance, MayStandForAnInstanceAndManyTimesForOneNode) {
    Database database;
    database.create(":", "ball", SphereNode{});
    database.createInstance(":", "one", ":ball");
    EXPECT_EQ(std::get<InstanceNode>(database.createInstance(":", "two", ":one").content).target,
              &database.find(":one"));
    EXPECT_NO_THROW(database.createInstance(":", "three", ":one"));
    expectError(
        database, [&] { database.createInstance(":ball", "i", ":two"); }, cycle(":two", ":ball"));
}

// Each level holds the one below twice: the ways through are 2^60, the nodes few.
TEST(Instance, ManyWaysToACycleAreNotWalkedOneByOne) {
    Database database;
    database.create(":", "0", TransformNode{});
    for (int i = 1; i <= 60; ++i) {
        const std::string level = ":" + std::to_string(i), below = ":" + std::to_string(i - 1);
        database.create(":", level.substr(1), TransformNode{});
        database.createInstance(level, "a", below);
        database.createInstance(level, "b", below);
    }
    expectError(
        database, [&] { database.createInstance(":0", "i", ":60"); }, cycle(":60", ":0"));
    EXPECT_NO_THROW(database.createInstance(":60", "i", ":0"));
}

TEST(Instance, WhatIsInstancedIsNotRemoved) {
    Database database;
    database.create(":", "shelf", TransformNode{});
    database.create(":shelf", "ball", SphereNode{});
    database.createInstance(":", "copy", ":shelf:ball");
    expectError(
        database, [&] { database.remove(":shelf:ball"); }, instanced(":shelf:ball", ":copy"));
    expectError(
        database, [&] { database.remove(":shelf"); }, instanced(":shelf:ball", ":copy"));
    // Without the instance it can go.
    database.remove(":copy");
    database.remove(":shelf");
    EXPECT_EQ(database.print(":"), ": transform");
}

TEST(Instance, IsRemovedTogetherWithItsTarget) {
    Database database;
    database.create(":", "all", TransformNode{});
    database.create(":all", "ball", SphereNode{});
    database.createInstance(":all", "copy", ":all:ball");
    database.createInstance(":all", "copyOfCopy", ":all:copy");
    expectError(
        database, [&] { database.remove(":all:copy"); }, instanced(":all:copy", ":all:copyOfCopy"));
    database.remove(":all");
    EXPECT_EQ(database.nodeCount(), 1u);
}

TEST(Instance, EveryInstanceMustGoFirst) {
    Database database;
    database.create(":", "ball", SphereNode{});
    database.createInstance(":", "one", ":ball");
    database.createInstance(":", "two", ":ball");
    database.remove(":one");
    expectError(
        database, [&] { database.remove(":ball"); }, instanced(":ball", ":two"));
    database.remove(":two");
    database.remove(":ball");
    EXPECT_EQ(database.nodeCount(), 1u);
}

// A removed instance holds nothing any more.
TEST(Instance, ARemovedOneMakesNoCycle) {
    Database database;
    database.create(":", "a", TransformNode{});
    database.create(":", "b", TransformNode{});
    database.createInstance(":a", "i", ":b");
    database.remove(":a:i");
    EXPECT_NO_THROW(database.createInstance(":b", "i", ":a"));
    database.remove(":b");
    database.remove(":a");
    EXPECT_EQ(database.nodeCount(), 1u);
}

}  // namespace
}  // namespace gr
