// The faces that lanes test one after the other, and which of them may stand in the way of light.
// Seen to fail with triangles joined whatever their fourth corner, with every face taken for a wall that has nothing
// behind it, with point lights left out of what lies behind, with mirrored meshes not turned,
// with needles among the faces, and with more faces than a few.
#include "gr/accelerators/face_list.h"

#include "gr/random_shapes.h"
#include "render/test_scene.h"

#include <gtest/gtest.h>

namespace render {
namespace {

struct Room : TestScene {
    Room() { add("room", gr::polyhedronNode(gr::cubeMesh()), core::Rgbf(0.5f)); }
    // A square across the room, at a height.
    void addShelf(double y) {
        addPolygon("shelf", {{-0.5, y, -0.5}, {-0.5, y, 0.5}, {0.5, y, 0.5}, {0.5, y, -0.5}}, core::Rgbf(0.5f));
    }
    gr::FaceList faces() const { return facesOf(gr::compile(database, ":", pointLights)); }
};

TEST(FaceList, JoinsTrianglesToParallelograms) {
    const gr::FaceList faces = Room().faces();
    EXPECT_EQ(faces.parallelograms.size(), 6u);
    EXPECT_EQ(faces.triangles.size(), 0u);
    for (const gr::Face& face : faces.parallelograms) {
        EXPECT_FLOAT_EQ(glm::length(glm::cross(face.edge1, face.edge2)), 4);
        EXPECT_FLOAT_EQ(glm::dot(face.normal, face.corner), 1) << "outward, at distance 1";
        EXPECT_FLOAT_EQ(glm::dot(face.toU, face.edge1), 1);
        EXPECT_FLOAT_EQ(glm::dot(face.toV, face.edge2), 1);
        EXPECT_NEAR(glm::dot(face.toU, face.edge2), 0, 1e-6);
        EXPECT_NEAR(glm::dot(face.toV, face.edge1), 0, 1e-6);
    }
}

TEST(FaceList, LeavesOtherTrianglesAsTheyAre) {
    TestScene kite;
    kite.addPolygon("kite", {{0, 0, 0}, {1, 0, 0}, {1.001, 1, 0}, {0, 1, 0}}, core::Rgbf(0.5f));
    const gr::FaceList faces = facesOf(gr::compile(kite.database, ":", {}));
    EXPECT_EQ(faces.parallelograms.size(), 0u);
    EXPECT_EQ(faces.triangles.size(), 2u);
}

TEST(FaceList, KeepsNormalsOutwardWhereAMeshIsMirrored) {
    Room room;
    room.database.scale(":room", glm::dvec3(0), {1, -1, 2});
    const gr::FaceList faces = room.faces();
    ASSERT_EQ(faces.size(), 6u);
    for (const gr::Face& face : faces.parallelograms) EXPECT_GT(glm::dot(face.normal, face.corner), 0.9f);
}

TEST(FaceList, WallsRoundEverythingDoNotBlock) {
    Room room;
    room.add("ball", gr::SphereNode{{0, -0.5, 0}, 0.5}, core::Rgbf(0.5f));  // stands on the floor
    EXPECT_EQ(room.faces().blockingParallelograms, 0u);
}

TEST(FaceList, AFaceBlocksThatHasSomethingOnEitherSide) {
    Room room;
    room.addShelf(0.3);
    const gr::FaceList faces = room.faces();
    ASSERT_EQ(faces.blockingParallelograms, 1u);
    EXPECT_FLOAT_EQ(faces.parallelograms[0].corner.y, 0.3f) << "they come first";
}

TEST(FaceList, ALampUnderTheCeilingBlocks) {
    Room room;
    room.addAreaLight("lamp", core::Rgbf(1), {0, 0.999, 0}, 0.5);
    const gr::FaceList faces = room.faces();
    ASSERT_EQ(faces.blockingParallelograms, 1u);
    EXPECT_EQ(faces.parallelograms[0].light, 0);
    EXPECT_EQ(faces.parallelograms[0].normal, core::Vec3f(0, -1, 0));
}

TEST(FaceList, AWallBlocksThatHasOnlyALightBehindIt) {
    for (const double beyond : {0.5, 1.5}) {
        Room room;
        room.addPointLight("bulb", {core::Vec3f(0, 0, static_cast<float>(beyond)), core::Rgbf(1), {1, 0, 0}});
        EXPECT_EQ(room.faces().blockingParallelograms, beyond > 1 ? 1u : 0u);
    }
}

// A face is tested a hair too large; a needle would become many times as wide.
TEST(FaceList, LeavesMeshesWithNeedlesToTheTriangles) {
    TestScene needle;
    needle.addPolygon("wall", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, core::Rgbf(0.5f));
    needle.addPolygon("needle", {{0, 0, -500}, {0.001, 0, -500}, {0.0005, 0, 500}}, core::Rgbf(0.5f));
    const gr::Scene scene = gr::compile(needle.database, ":", {});
    EXPECT_EQ(scene.faces.size(), 1u);
    EXPECT_EQ(scene.bodies.size() + scene.large.size(), 1u);
}

TEST(FaceList, IsEmptyWhereThereAreMoreThanAFew) {
    for (const int walls : {64, 65}) {
        TestScene many;
        for (int i = 0; i < walls; ++i)
            many.addPolygon("wall" + std::to_string(i), {{0, 0, i}, {1, 0, i}, {1, 1, i}, {0, 1, i}}, core::Rgbf(0.5f));
        const gr::Scene scene = gr::compile(many.database, ":", {});
        EXPECT_EQ(scene.faces.size(), walls == 64 ? 64u : 0u);
        EXPECT_EQ(scene.bodies.size(), walls == 64 ? 0u : 65u);
    }
}

}  // namespace
}  // namespace render
