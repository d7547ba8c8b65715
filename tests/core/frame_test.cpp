#include "core/frame.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/test_random.h"

namespace core {
namespace {

// Everywhere, close to the axes on both sides, and on them; the z axes, where a frame may degenerate, with both zeros.
std::vector<Vec3f> normals() {
    std::vector<Vec3f> normals{{0, 0, 1},  {0, 0, -1},   {-0.f, -0.f, -1}, {1, 0, 0},       {-1, 0, 0},    {0, 1, 0},
                               {0, -1, 0}, {1, 0, -0.f}, {0, 1, -0.f},     {1, 0, -1e-40f}, {0, 1, 1e-40f}};
    support::TestRandom random(2);
    for (int i = 0; i < 100'000; ++i) {
        // Each component is shrunk on its own, many of them very much.
        glm::dvec3 v;
        for (int axis = 0; axis < 3; ++axis) {
            const double coordinate = 2 * random.next() - 1;
            const bool small = random.next() < 0.5;
            const double exponent = -12 * random.next();
            v[axis] = coordinate * (small ? std::pow(10, exponent) : 1);
        }
        normals.emplace_back(glm::normalize(v));
    }
    return normals;
}

std::string text(const Vec3f& v) {
    return std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z);
}

// The frame's own rounding and that of the normal's length.
constexpr double rounding = 1e-6;

TEST(Frame, IsOrthonormalAndRightHanded) {
    for (const Vec3f& normal : normals()) {
        const Frame<float> frame(normal);
        ASSERT_EQ(frame.z, normal);
        const glm::dvec3 x(frame.x), y(frame.y), z(frame.z);
        const double worst =
            std::max({std::abs(glm::dot(x, x) - 1), std::abs(glm::dot(y, y) - 1), std::abs(glm::dot(x, y)),
                      std::abs(glm::dot(x, z)), std::abs(glm::dot(y, z)), glm::length(glm::cross(x, y) - z)});
        ASSERT_LT(worst, rounding) << normal.x << " " << normal.y << " " << normal.z;
    }
}

TEST(Frame, TakesTheNormalToZ) {
    for (const Vec3f& normal : normals()) {
        const Frame<float> frame(normal);
        ASSERT_LT(glm::length(frame.toLocal(normal) - Vec3f(0, 0, 1)), rounding);
        ASSERT_EQ(frame.toWorld(Vec3f(0, 0, 1)), normal);
    }
}

// Lanes of different widths negate a zero differently. Seen to fail with copysign in place of the comparison.
TEST(Frame, IsTheSameForBothZeros) {
    support::TestRandom random(4);
    for (int i = 0; i < 100; ++i) {
        const double angle = 2 * M_PI * random.next();
        const Vec3f normal(std::cos(angle), std::sin(angle), 0);
        const Frame<float> frame(normal), other(Vec3f(normal.x, normal.y, -0.f));
        EXPECT_EQ(frame.x, other.x) << text(normal);
        EXPECT_EQ(frame.y, other.y) << text(normal);
    }
}

TEST(Frame, GoesThereAndBack) {
    support::TestRandom random(3);
    const auto coordinate = [&random] { return 2 * random.next() - 1; };
    for (const Vec3f& normal : normals()) {
        const Frame<float> frame(normal);
        const double x = coordinate(), y = coordinate(), z = coordinate();
        const Vec3f v(x, y, z);
        ASSERT_LT(glm::length(frame.toWorld(frame.toLocal(v)) - v), 2 * rounding);
        ASSERT_LT(glm::length(frame.toLocal(frame.toWorld(v)) - v), 2 * rounding);
        // World coordinates are measured along the axes.
        ASSERT_NEAR(frame.toLocal(v).x, glm::dot(glm::dvec3(v), glm::dvec3(frame.x)), rounding);
        ASSERT_NEAR(frame.toLocal(v).y, glm::dot(glm::dvec3(v), glm::dvec3(frame.y)), rounding);
    }
}

// Tangents of any length, aslant too.
TEST(FrameWithATangent, IsOrthonormalWithItsXAxisAlongTheTangent) {
    support::TestRandom random(4);
    for (const Vec3f& normal : normals()) {
        glm::dvec3 tangent;
        for (int axis = 0; axis < 3; ++axis) tangent[axis] = 2 * random.next() - 1;
        const double size = std::pow(10, 8 * random.next() - 4);
        tangent *= size;
        const glm::dvec3 z(normal);
        const glm::dvec3 across = tangent - z * glm::dot(z, tangent);
        // What is left of a tangent along the normal is rounding.
        if (glm::length(across) < 0.1 * glm::length(tangent)) continue;
        const Frame<float> frame(normal, Vec3f(tangent));
        ASSERT_EQ(frame.z, normal);
        const glm::dvec3 x(frame.x), y(frame.y);
        const double worst = std::max({std::abs(glm::dot(x, x) - 1), std::abs(glm::dot(y, y) - 1),
                                       std::abs(glm::dot(x, y)), std::abs(glm::dot(x, z)), std::abs(glm::dot(y, z)),
                                       glm::length(glm::cross(x, y) - z), glm::length(x - glm::normalize(across))});
        ASSERT_LT(worst, 4 * rounding) << text(normal) << ", " << text(Vec3f(tangent));
    }
}

TEST(FrameWithATangent, KeepsATangentAcrossTheNormal) {
    const Frame<float> frame(Vec3f(0, 0, -1), Vec3f(0, 3, 0));
    EXPECT_EQ(frame.x, Vec3f(0, 1, 0));
    EXPECT_EQ(frame.y, Vec3f(1, 0, 0));
    EXPECT_EQ(frame.toWorld(Vec3f(1, 2, 3)), Vec3f(2, 1, -3));
    EXPECT_EQ(frame.toLocal(Vec3f(2, 1, -3)), Vec3f(1, 2, 3));
}

}  // namespace
}  // namespace core
