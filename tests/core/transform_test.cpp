#include "core/transform.h"

#include <gtest/gtest.h>

#include <glm/matrix.hpp>

#include "support/test_random.h"

namespace core {
namespace {

class TransformTest : public testing::Test {
protected:
    support::TestRandom random{4};

    double coordinate(double size) { return size * (2 * random.next() - 1); }

    glm::dvec3 vector(double size) {
        const double x = coordinate(size), y = coordinate(size), z = coordinate(size);
        return glm::vec3(x, y, z);
    }

    // Affine, of entries from 10^-3 to 10^3 that float holds exactly.
    glm::dmat4 matrix() {
        glm::dmat4 m(1);
        for (int column = 0; column < 4; ++column)
            m[column] = glm::dvec4(vector(std::pow(10, coordinate(3))), column == 3 ? 1 : 0);
        return m;
    }
};

// Four roundings, each relative to the sum of the absolute values.
void expectNear(const Vec3f& result, const glm::dvec3& expected, const glm::dvec3& sizes) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(result[axis], expected[axis], 4 * 0x1p-24 * sizes[axis]);
}

glm::dmat3 absolute(const glm::dmat3& m) {
    return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])};
}

TEST_F(TransformTest, IsTheIdentityByDefault) {
    for (int i = 0; i < 100; ++i) {
        const Vec3f v(vector(10));
        EXPECT_EQ(Transform().point(v), v);
        EXPECT_EQ(Transform().vector(v), v);
        EXPECT_EQ(Transform().transposed(v), v);
    }
}

TEST_F(TransformTest, AgreesWithMatricesInDouble) {
    for (int i = 0; i < 10'000; ++i) {
        const glm::dmat4 m = matrix();
        const glm::dmat3 linear(m);
        const Transform transform(m);
        const glm::dvec3 v = vector(10);
        const glm::dvec3 sizes = absolute(linear) * glm::abs(v);
        expectNear(transform.point(Vec3f(v)), glm::dvec3(m * glm::dvec4(v, 1)), sizes + glm::abs(glm::dvec3(m[3])));
        expectNear(transform.vector(Vec3f(v)), linear * v, sizes);
        expectNear(transform.transposed(Vec3f(v)), glm::transpose(linear) * v,
                   glm::transpose(absolute(linear)) * glm::abs(v));
    }
}

// What a normal needs: it stays at right angles to what lay in the plane.
TEST_F(TransformTest, KeepsANormalByTheTransposedInverse) {
    for (int i = 0; i < 1000; ++i) {
        const glm::dmat4 m = matrix();
        const Transform there(m), back(glm::inverse(m));
        const glm::dvec3 inPlane = vector(1);
        const glm::dvec3 normal = glm::cross(inPlane, vector(1));
        const glm::dvec3 movedInPlane(there.vector(Vec3f(inPlane)));
        const glm::dvec3 movedNormal(back.transposed(Vec3f(normal)));
        // The products that cancel bound what rounding may leave of them.
        const glm::dvec3 sizes = absolute(glm::dmat3(m)) * glm::abs(inPlane);
        const glm::dvec3 normalSizes = absolute(glm::transpose(glm::inverse(glm::dmat3(m)))) * glm::abs(normal);
        EXPECT_NEAR(glm::dot(movedInPlane, movedNormal), 0, 12 * 0x1p-24 * glm::dot(sizes, normalSizes));
    }
}

}  // namespace
}  // namespace core
