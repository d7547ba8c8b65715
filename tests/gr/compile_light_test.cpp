// A square light under affine maps.
#include "gr/error_of.h"
#include "gr/scene.h"

#include <glm/ext/matrix_transform.hpp>

namespace gr {
namespace {

constexpr double tolerance = 1e-5;

void expectNear(const core::Vec3f& actual, const glm::dvec3& expected) {
    EXPECT_LE(glm::length(glm::dvec3(actual) - expected), tolerance * (1 + glm::length(expected)))
        << actual.x << " " << actual.y << " " << actual.z;
}

class CompileLightTest : public testing::Test {
protected:
    CompileLightTest() { database.create(":", "l", AreaLightNode{{3, 2, 1}, {1, 2, 3}, 4}); }

    // The light's corners are where the map puts the square's; its normal is square to its edges, of unit length, and
    // on the side to which the map puts what lies below the square.
    void expectMapped() {
        const Scene scene = compile(database, ":", {});
        ASSERT_EQ(scene.lights.of<AreaLight>().size(), 1u);
        const AreaLight& light = scene.lights.of<AreaLight>()[0];
        const Node& node = database.find(":l");
        const glm::dmat4 matrix = node.matrix ? *node.matrix : glm::dmat4(1);
        const auto map = [&](double x, double y, double z) { return glm::dvec3(matrix * glm::dvec4(x, y, z, 1)); };
        expectNear(light.corner, map(-1, 2, 1));
        expectNear(light.corner + light.edge1, map(3, 2, 1));
        expectNear(light.corner + light.edge2, map(-1, 2, 5));
        const glm::dvec3 across = glm::cross(glm::dvec3(light.edge1), glm::dvec3(light.edge2));
        EXPECT_NEAR(light.area, glm::length(across), tolerance * light.area);
        EXPECT_NEAR(glm::length(light.normal), 1, tolerance);
        EXPECT_NEAR(std::abs(glm::dot(glm::dvec3(light.normal), glm::normalize(across))), 1, tolerance);
        EXPECT_GT(glm::dot(glm::dvec3(light.normal), map(1, 1, 3) - map(1, 2, 3)), 0);
        EXPECT_EQ(light.radiance, core::Rgbf(3, 2, 1));
    }

    Database database;
};

TEST_F(CompileLightTest, ASquareAboutItsCentreFacingDown) {
    const Scene scene = compile(database, ":", {});
    ASSERT_EQ(scene.lights.of<AreaLight>().size(), 1u);
    const AreaLight& light = scene.lights.of<AreaLight>()[0];
    expectNear(light.corner, {-1, 2, 1});
    expectNear(light.edge1, {4, 0, 0});
    expectNear(light.edge2, {0, 0, 4});
    expectNear(light.normal, {0, -1, 0});
    EXPECT_FLOAT_EQ(light.area, 16);
    expectMapped();
}

TEST_F(CompileLightTest, Translated) {
    database.translate(":l", {10, -20, 30});
    expectMapped();
}

TEST_F(CompileLightTest, Turned) {
    database.rotate(":l", 0, 180);
    database.rotate(":l", 2, 33);
    database.rotate(":l", 1, -70);
    expectMapped();
    EXPECT_FLOAT_EQ(compile(database, ":", {}).lights.of<AreaLight>()[0].area, 16);
}

TEST_F(CompileLightTest, Stretched) {
    database.scale(":l", {1, 1, 1}, {2, 5, 3});
    expectMapped();
    EXPECT_FLOAT_EQ(compile(database, ":", {}).lights.of<AreaLight>()[0].area, 96);
}

TEST_F(CompileLightTest, MirroredAcrossEachAxis) {
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 by(1);
        by[axis] = -1;
        database.scale(":l", {0, 0, 0}, by);
        expectMapped();
        // Mirrored up and down it faces up; mirrored sideways it still faces down.
        expectNear(compile(database, ":", {}).lights.of<AreaLight>()[0].normal, {0, axis == 1 ? 1 : -1, 0});
        database.scale(":l", {0, 0, 0}, by);
    }
}

TEST_F(CompileLightTest, Sheared) {
    // Turned between two scales the square becomes a parallelogram, and its normal goes another way than its points.
    database.scale(":l", {0, 0, 0}, {1, 4, 1});
    database.rotate(":l", 2, 45);
    database.rotate(":l", 1, 30);
    expectMapped();
    database.scale(":l", {1, 2, 3}, {0.5, -2, 3});
    database.rotate(":l", 0, 20);
    expectMapped();
    const AreaLight light = compile(database, ":", {}).lights.of<AreaLight>()[0];
    EXPECT_GT(std::abs(glm::dot(light.edge1, light.edge2)), 0.1f);
}

TEST_F(CompileLightTest, AParentsAndAnInstancesMatricesCountToo) {
    database.create(":", "lamps", TransformNode{});
    database.createInstance(":lamps", "one", ":l");
    database.createInstance(":lamps", "two", ":l");
    database.scale(":lamps", {0, 0, 0}, {2, 1, 1});
    database.rotate(":lamps:two", 0, 90);
    const Scene scene = compile(database, ":", {});
    ASSERT_EQ(scene.lights.of<AreaLight>().size(), 3u);
    ASSERT_EQ(scene.instances.size(), 3u);
    expectNear(scene.lights.of<AreaLight>()[1].normal, {0, -1, 0});
    expectNear(scene.lights.of<AreaLight>()[2].normal, {0, 0, -1});
    for (std::uint32_t i = 0; i < 3; ++i) {
        EXPECT_EQ(std::get<Square>(scene.instances[i].shape).light, i);
        EXPECT_FLOAT_EQ(scene.lights.of<AreaLight>()[i].area, i == 0 ? 16 : 32);
    }
}

TEST(CompileLight, OthersAreNone) {
    Database database;
    database.create(":", "s", SphereNode{});
    database.create(":", "l", AreaLightNode{{1, 1, 1}, {0, 0, 0}, 1});
    const Scene scene = compile(database, ":", {});
    EXPECT_FALSE(std::holds_alternative<Square>(scene.instances[0].shape));
    EXPECT_EQ(std::get<Square>(scene.instances[1].shape).light, 0u);
}

}  // namespace
}  // namespace gr
