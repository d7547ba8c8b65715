// The u axis of surfaces: eastwards about the object's own y axis, wherever the object is turned to.
// Seen to fail with the world's y axis, a tangent to the west, the map of normals for that of vectors, and no care of
// the poles.
#include "core/frame.h"
#include "gr/random_shapes.h"
#include "gr/scene.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::Vec3f;

class TangentTest : public testing::Test {
protected:
    // Turned, stretched, mirrored.
    void place(const NodeContent& content, bool mirrored) {
        Database database;
        database.create(":", "place", TransformNode{});
        database.translate(":place", {3, -1, 2});
        squeezeAtRandom(database, ":place", 2, 0.7, random);
        if (mirrored) database.scale(":place", glm::dvec3(0), {1, 1, -1});
        database.create(":place", "shape", content);
        matrix = *database.find(":place").matrix;
        scene = compile(database, ":", {});
        accelerator = makeNoAccelerator(scene);
    }
    // Where the way from outside to a point in object space ends.
    SurfacePoint<float> surfaceAt(const glm::dvec3& target, const glm::dvec3& from) {
        const Vec3f origin(transformed(matrix, from));
        const core::Rayf ray{origin, glm::normalize(Vec3f(transformed(matrix, target)) - origin)};
        return scene.surfaceAt(ray, accelerator->intersect(ray).value());
    }
    glm::dvec3 toWorld(const glm::dvec3& vector) const { return glm::normalize(glm::dmat3(matrix) * vector); }

    support::TestRandom random{3};
    glm::dmat4 matrix{1};
    Scene scene;
    std::unique_ptr<Accelerator> accelerator;
};

glm::dvec3 unit(const Vec3f& v) {
    return glm::normalize(glm::dvec3(v));
}

void expectAcross(const SurfacePoint<float>& surface) {
    EXPECT_NEAR(glm::dot(unit(surface.tangent), unit(surface.normal)), 0, 1e-5);
    const core::Frame<float> frame(surface.normal, surface.tangent);
    EXPECT_NEAR(glm::dot(frame.x, frame.z), 0, 3e-7);
    EXPECT_NEAR(glm::length(frame.x), 1, 3e-7);
    EXPECT_GT(glm::dot(frame.x, surface.tangent), 0);
}

// One step in longitude from a point, in object space.
glm::dvec3 eastwards(const glm::dvec3& p) {
    constexpr double step = 1e-6;
    return glm::dvec3(p.x * std::cos(step) + p.z * std::sin(step), p.y, p.z * std::cos(step) - p.x * std::sin(step)) -
           p;
}

TEST_F(TangentTest, FollowsTheLongitudeOfASphere) {
    for (const bool mirrored : {false, true}) {
        for (int i = 0; i < 20; ++i) {
            place(SphereNode{}, mirrored);
            for (int j = 0; j < 50; ++j) {
                const glm::dvec3 p = randomDirection(random);
                if (std::abs(p.y) > 0.999) continue;
                const SurfacePoint surface = surfaceAt(p, 3.0 * p);
                EXPECT_LT(glm::distance(unit(surface.tangent), toWorld(eastwards(p))), 2e-4) << mirrored;
                expectAcross(surface);
            }
        }
    }
}

TEST_F(TangentTest, IsTheSameFromInside) {
    place(SphereNode{}, false);
    const glm::dvec3 p = glm::normalize(glm::dvec3(1, 2, -1));
    EXPECT_LT(glm::distance(unit(surfaceAt(p, {0, 0, 0}).tangent), toWorld(eastwards(p))), 1e-4);
}

TEST_F(TangentTest, IsTheXAxisAtThePoles) {
    place(SphereNode{}, false);
    for (const double pole : {-1., 1.}) {
        const SurfacePoint surface = surfaceAt({0, pole, 0}, {0, 3 * pole, 0});
        EXPECT_TRUE(core::isFinite(surface.tangent));
        EXPECT_GT(glm::length(surface.tangent), 0);
        expectAcross(surface);
    }
    place(BoxNode{glm::dvec3(-1), glm::dvec3(2)}, false);
    EXPECT_LT(glm::distance(unit(surfaceAt({0.3, 1, 0.2}, {0, 3, 0}).tangent), toWorld({1, 0, 0})), 1e-5);
}

TEST_F(TangentTest, IsOneForAFlatFace) {
    for (const NodeContent& content :
         {NodeContent(BoxNode{glm::dvec3(-1), glm::dvec3(2)}), NodeContent(polyhedronNode(cubeMesh()))}) {
        place(content, false);
        for (int face = 0; face < 6; ++face) {
            const int axis = face / 2;
            glm::dvec3 normal(0);
            normal[axis] = face % 2 == 0 ? 1 : -1;
            const glm::dvec3 expected = axis == 1 ? glm::dvec3(1, 0, 0) : glm::cross(glm::dvec3(0, 1, 0), normal);
            for (int i = 0; i < 50; ++i) {
                glm::dvec3 target = randomPoint(random, -0.95, 0.95);
                target[axis] = normal[axis];
                const SurfacePoint surface = surfaceAt(target, target + 2.0 * normal);
                EXPECT_LT(glm::distance(unit(surface.tangent), toWorld(expected)), 1e-5) << "face " << face;
                expectAcross(surface);
            }
        }
    }
}

// From one of a mesh's triangles to the next it turns no more than they do.
TEST_F(TangentTest, HasNoSeamOnAMeshOfASphere) {
    place(polyhedronNode(icosphereMesh(3)), false);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 p = randomDirection(random);
        if (std::abs(p.y) > 0.8) continue;
        const SurfacePoint surface = surfaceAt(0.99 * p, 3.0 * p);
        const glm::dvec3 inObject = glm::inverse(glm::dmat3(matrix)) * glm::dvec3(surface.tangent);
        EXPECT_GT(glm::dot(glm::normalize(inObject), glm::normalize(eastwards(p))), std::cos(0.25));
        expectAcross(surface);
    }
}

}  // namespace
}  // namespace gr
