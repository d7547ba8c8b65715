#include "gr/error_of.h"

#include <glm/ext/matrix_transform.hpp>

#include <cmath>
#include <random>

namespace gr {
namespace {

class TransformTest : public testing::Test {
protected:
    TransformTest() { database.create(":", "n", TransformNode{}); }
    glm::dvec3 map(const glm::dvec3& p) const {
        const Node& node = database.find(":n");
        return node.matrix ? glm::dvec3(*node.matrix * glm::dvec4(p, 1)) : p;
    }
    void expectMap(const glm::dvec3& from, const glm::dvec3& to) const {
        EXPECT_LE(glm::length(map(from) - to), 1e-14 * (1 + glm::length(to)));
    }

    Database database;
};

TEST_F(TransformTest, ANodeHasNoMatrixUntilItIsTransformed) {
    EXPECT_EQ(database.find(":n").matrix, nullptr);
    database.translate(":n", {1, 2, 3});
    ASSERT_NE(database.find(":n").matrix, nullptr);
    EXPECT_EQ(database.find(":").matrix, nullptr);
}

TEST_F(TransformTest, TheRootAndLeavesTakeTransformsToo) {
    database.create(":n", "ball", SphereNode{});
    database.translate(":", {1, 0, 0});
    database.translate(":n:ball", {0, 1, 0});
    EXPECT_EQ(glm::dvec3((*database.find(":").matrix)[3]), glm::dvec3(1, 0, 0));
    EXPECT_EQ(glm::dvec3((*database.find(":n:ball").matrix)[3]), glm::dvec3(0, 1, 0));
}

TEST_F(TransformTest, Translates) {
    database.translate(":n", {1, 2, 3});
    EXPECT_EQ(map({10, 20, 30}), glm::dvec3(11, 22, 33));
}

TEST_F(TransformTest, RotatesByTheRightHand) {
    const glm::dvec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double degrees : {30.0, -45.0, 100.0, 1234.5}) {
            database.reset();
            database.create(":", "n", TransformNode{});
            database.rotate(":n", axis, degrees);
            const glm::dmat4 expected = glm::rotate(glm::dmat4(1), glm::radians(degrees), axes[axis]);
            expectMap({1, 2, 3}, glm::dvec3(expected * glm::dvec4(1, 2, 3, 1)));
        }
    }
}

TEST_F(TransformTest, QuarterTurnsAreExact) {
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const int quarters : {-7, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 4000001}) {
            database.reset();
            database.create(":", "n", TransformNode{});
            database.rotate(":n", axis, 90.0 * quarters);
            glm::dvec3 expected(7, 11, 13);
            for (int i = 0; i < (quarters % 4 + 4) % 4; ++i) {
                const glm::dvec3 before = expected;
                expected[u] = -before[v];
                expected[v] = before[u];
            }
            EXPECT_EQ(map({7, 11, 13}), expected) << "axis " << axis << ", " << quarters << " quarters";
        }
    }
}

TEST_F(TransformTest, FourQuarterTurnsAreNone) {
    for (int i = 0; i < 4; ++i) database.rotate(":n", 1, 90);
    EXPECT_EQ(*database.find(":n").matrix, glm::dmat4(1));
}

// Of each axis and its length; along x, y or z bit for bit the turn about that.
TEST_F(TransformTest, RotatesAboutAnyAxisOfAnyLength) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 axis(normal(random), normal(random), normal(random));
        const double degrees = 400 * normal(random), length = std::pow(10, 60 * normal(random));
        database.forgetTransforms(":n");
        database.rotate(":n", axis * length, degrees);
        const glm::dmat4 expected = glm::rotate(glm::dmat4(1), glm::radians(degrees), axis);
        expectMap({1, 2, 3}, glm::dvec3(expected * glm::dvec4(1, 2, 3, 1)));
        expectMap(axis, axis);
    }
    for (int i = 0; i < 3; ++i) {
        for (const double length : {5.0, -1e-300}) {
            glm::dvec3 axis(0);
            axis[i] = length;
            database.forgetTransforms(":n");
            database.rotate(":n", axis, 30);
            const glm::dmat4 turned = *database.find(":n").matrix;
            database.forgetTransforms(":n");
            database.rotate(":n", i, length > 0 ? 30 : -30);
            EXPECT_EQ(turned, *database.find(":n").matrix);
        }
    }
}

TEST_F(TransformTest, TurnsMinusZToTheTarget) {
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    const auto any = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 eye = any(), target = any(), up = any();
        database.forgetTransforms(":n");
        database.lookAt(":n", eye, target, up * std::pow(10, 60 * normal(random)));
        const glm::dmat4 expected = glm::inverse(glm::lookAt(eye, target, up));
        for (const glm::dvec3& p : {glm::dvec3(0), glm::dvec3(1, 2, 3)})
            EXPECT_LE(glm::length(map(p) - glm::dvec3(expected * glm::dvec4(p, 1))), 1e-9);
        EXPECT_LE(glm::length(map({0, 0, -glm::distance(eye, target)}) - target), 1e-13 * (1 + glm::length(target)));
    }
}

TEST_F(TransformTest, MultipliesByAMatrixOnTheRight) {
    database.translate(":n", {1, 0, 0});
    database.multiply(":n", glm::scale(glm::dmat4(1), {2, 3, 4}));
    EXPECT_EQ(map({1, 1, 1}), glm::dvec3(3, 3, 4));
}

TEST_F(TransformTest, ForgetsThemAll) {
    database.translate(":n", {1, 2, 3});
    database.forgetTransforms(":n");
    EXPECT_EQ(database.find(":n").matrix, nullptr);
    database.forgetTransforms(":n");
}

TEST_F(TransformTest, Scales) {
    database.scale(":n", {0, 0, 0}, {2, 3, -4});
    EXPECT_EQ(map({1, 1, 1}), glm::dvec3(2, 3, -4));
    EXPECT_EQ(map({0, 0, 0}), glm::dvec3(0, 0, 0));
}

TEST_F(TransformTest, ScalesAboutAPointThatStays) {
    database.scale(":n", {1, 2, 3}, {2, 4, 0.5});
    EXPECT_EQ(map({1, 2, 3}), glm::dvec3(1, 2, 3));
    EXPECT_EQ(map({2, 3, 4}), glm::dvec3(3, 6, 3.5));
}

TEST_F(TransformTest, TheLastOneWrittenActsFirst) {
    database.translate(":n", {10, 0, 0});
    database.rotate(":n", 2, 90);
    database.scale(":n", {0, 0, 0}, {2, 1, 1});
    // (1 0 0) is scaled to (2 0 0), turned to (0 2 0) and moved to (10 2 0).
    EXPECT_EQ(map({1, 0, 0}), glm::dvec3(10, 2, 0));
}

TEST_F(TransformTest, TheOtherWayRoundTheTurnComesLast) {
    database.scale(":n", {0, 0, 0}, {2, 1, 1});
    database.rotate(":n", 2, 90);
    database.translate(":n", {10, 0, 0});
    // (1 0 0) is moved to (11 0 0), turned to (0 11 0), which the scale leaves alone.
    EXPECT_EQ(map({1, 0, 0}), glm::dvec3(0, 11, 0));
}

TEST_F(TransformTest, AMatrixBeyondSinglePrecisionIsRefusedAndKept) {
    const std::string message = "VALUE RANGE [:n] the matrix of \":n\" grows beyond numbers";
    expectError(
        database,
        [&] {
            database.translate(":n", {1e39, 0, 0});
        },
        message);
    EXPECT_EQ(database.find(":n").matrix, nullptr);

    database.scale(":n", {0, 0, 0}, {1e30, 1, 1});
    const glm::dmat4 before = *database.find(":n").matrix;
    expectError(
        database,
        [&] {
            database.scale(":n", {0, 0, 0}, {1e9, 1, 1});
        },
        message);
    expectError(
        database,
        [&] {
            database.translate(":n", {1e9, 0, 0});
        },
        message);
    expectError(
        database,
        [&] {
            database.translate(":n", {0, 0, std::nan("")});
        },
        message);
    expectError(
        database, [&] { database.rotate(":n", 0, std::numeric_limits<double>::infinity()); }, message);
    EXPECT_EQ(*database.find(":n").matrix, before);
    EXPECT_NO_THROW(database.translate(":n", {1e7, 0, 0}));
}

}  // namespace
}  // namespace gr
