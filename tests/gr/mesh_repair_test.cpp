#include "gr/mesh/mesh_repair.h"
#include "gr/cube_mesh.h"

#include "gr/error_of.h"
#include "gr/uv_sphere_mesh.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <bit>

namespace gr {
namespace {

using Faces = std::vector<std::vector<int>>;

// The steps work on flat meshes; the tests read better with faces that are lists.
template<class Step>
MeshRepairs apply(Step&& step, PolygonMesh& mesh) {
    FlatMesh flat(mesh);
    MeshRepairs repairs;
    step(flat, repairs);
    mesh.faces.clear();
    for (int f = 0; f < flat.faceCount(); ++f) mesh.faces.emplace_back(flat.face(f).begin(), flat.face(f).end());
    return repairs;
}

glm::dvec3 faceNormal(const PolygonMesh& mesh, const std::vector<int>& face) {
    return gr::faceNormal(mesh.vertices, face);
}

// A row of quads in the x-y plane, facing +z.
PolygonMesh strip(int quads) {
    PolygonMesh mesh;
    for (int i = 0; i <= quads; ++i)
        for (int y = 0; y < 2; ++y) mesh.vertices.emplace_back(i, y, 0);
    for (int i = 0; i < quads; ++i) mesh.faces.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    return mesh;
}

void turn(PolygonMesh& mesh, std::size_t face) {
    std::reverse(mesh.faces[face].begin(), mesh.faces[face].end());
}

void expectOutwards(const PolygonMesh& mesh, const glm::dvec3& inside) {
    for (const std::vector<int>& face : mesh.faces)
        EXPECT_GT(glm::dot(faceNormal(mesh, face), mesh.vertices[face[0]] - inside), 0);
}

MeshRepairs orient(PolygonMesh& mesh) {
    return apply(orientFaces, mesh);
}

MeshRepairs drop(PolygonMesh& mesh) {
    return apply(dropDegenerate, mesh);
}

TEST(MeshRepairs, TextSaysWhatWasMended) {
    EXPECT_EQ(MeshRepairs{}.text(), "");
    EXPECT_EQ((MeshRepairs{2, 0, 0, 0}.text()), "") << "vertices at one place are no fault";
    EXPECT_EQ((MeshRepairs{0, 1, 0, 0}.text()), "1 degenerate vertex dropped");
    EXPECT_EQ((MeshRepairs{0, 2, 0, 0}.text()), "2 degenerate vertices dropped");
    EXPECT_EQ((MeshRepairs{0, 0, 1, 0}.text()), "1 face without area dropped");
    EXPECT_EQ((MeshRepairs{0, 0, 2, 0}.text()), "2 faces without area dropped");
    EXPECT_EQ((MeshRepairs{0, 0, 0, 1}.text()), "1 wrong-way face turned");
    EXPECT_EQ((MeshRepairs{0, 0, 0, 2}.text()), "2 wrong-way faces turned");
    EXPECT_EQ((MeshRepairs{0, 0, 0, 0, 1}.text()), "1 self-crossing face dropped");
    EXPECT_EQ((MeshRepairs{0, 0, 0, 0, 0, 1}.text()), "1 line or point left out");
    EXPECT_EQ((MeshRepairs{1, 2, 3, 4, 5, 6}.text()),
              "2 degenerate vertices dropped, 3 faces without area dropped, "
              "4 wrong-way faces turned, 5 self-crossing faces dropped, 6 lines and points left out");
}

TEST(FaceNormal, IsTwiceTheAreaByTheRightHand) {
    PolygonMesh mesh{{{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}, {1, 1, 0}}, {}};
    EXPECT_EQ(faceNormal(mesh, {0, 1, 2, 3}), glm::dvec3(0, 0, 12));
    EXPECT_EQ(faceNormal(mesh, {3, 2, 1, 0}), glm::dvec3(0, 0, -12));
    EXPECT_EQ(faceNormal(mesh, {0, 1, 2, 3, 4}), glm::dvec3(0, 0, 10));  // concave: a notch of area 1
    EXPECT_EQ(faceNormal(mesh, {4, 0, 1, 2, 3}), glm::dvec3(0, 0, 10));
}

TEST(MergeVertices, LetsTheFirstOfThemStandForAll) {
    PolygonMesh mesh{{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {0, -0.0, 0}, {1, 2, 3}, {1, 2, 4}}, {{0, 1, 5}, {2, 3, 4, 5}}};
    const MeshRepairs repairs = apply(mergeVertices, mesh);
    EXPECT_EQ(repairs.mergedVertices, 3);
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 5}, {0, 1, 0, 5}}));
}

TEST(MergeVertices, LeavesNeighboursApart) {
    const double next = std::nextafter(1.0, 2.0);
    PolygonMesh mesh{{{1, 0, 0}, {next, 0, 0}, {1, 0, 1e-300}}, {{0, 1, 2}}};
    const MeshRepairs repairs = apply(mergeVertices, mesh);
    EXPECT_EQ(repairs.text(), "");
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
}

// Six faces with four vertices of their own each, as many programs write a cube.
TEST(MergeVertices, JoinsACubeOfSeparateFaces) {
    PolygonMesh mesh, joined = cubeMesh();
    for (const std::vector<int>& face : joined.faces) {
        std::vector<int>& own = mesh.faces.emplace_back();
        for (const int v : face) {
            own.push_back(static_cast<int>(mesh.vertices.size()));
            mesh.vertices.push_back(joined.vertices[v]);
        }
    }
    turn(mesh, 3);
    MeshRepairs repairs;
    EXPECT_EQ(Polyhedron::make(mesh, repairs)->triangleCount(), 12u);
    EXPECT_EQ(repairs.mergedVertices, 16);
    EXPECT_EQ(repairs.text(), "1 wrong-way face turned");
}

TEST(DropDegenerate, VerticesThatAFaceRepeats) {
    PolygonMesh mesh = strip(1);
    mesh.faces = {{0, 0, 2, 3, 3, 3, 1, 0}};
    const MeshRepairs repairs = drop(mesh);
    EXPECT_EQ(repairs.droppedVertices, 4);
    EXPECT_EQ(repairs.droppedFaces, 0);
    ASSERT_EQ(mesh.faces.size(), 1u);
    EXPECT_EQ(mesh.faces[0].size(), 4u);
    EXPECT_THAT(mesh.faces[0], testing::UnorderedElementsAre(0, 1, 2, 3));
    EXPECT_EQ(faceNormal(mesh, mesh.faces[0]), glm::dvec3(0, 0, 2));
}

TEST(DropDegenerate, SpikesThereAndStraightBack) {
    // Out to 4 and 5 and back again.
    PolygonMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {3, 1, 0}}, {{0, 1, 2, 4, 5, 4, 2, 3}}};
    const MeshRepairs repairs = drop(mesh);
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2, 3}}));
    EXPECT_EQ(repairs.text(), "4 degenerate vertices dropped");
}

TEST(DropDegenerate, KeepsAVertexOnAStraightEdge) {
    PolygonMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}}, {{0, 1, 2, 3}}};
    EXPECT_EQ(drop(mesh).text(), "");
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2, 3}}));
}

TEST(DropDegenerate, FacesWithoutArea) {
    PolygonMesh mesh = strip(2);
    mesh.vertices.emplace_back(3, 0, 0);
    // One vertex; two; three in a line; there and back; and one that is kept.
    mesh.faces = {{1, 1, 1}, {0, 1, 0}, {0, 2, 4}, {0, 2, 4, 6, 2}, {0, 2, 1}};
    const MeshRepairs repairs = drop(mesh);
    EXPECT_EQ(mesh.faces, (Faces{{0, 2, 1}}));
    EXPECT_EQ(repairs.text(), "4 faces without area dropped");  // their vertices are not counted as well
}

TEST(OrientFaces, LeavesARightCubeAlone) {
    PolygonMesh mesh = cubeMesh();
    EXPECT_EQ(orient(mesh).turnedFaces, 0);
    EXPECT_EQ(mesh.faces, cubeMesh().faces);
}

// Every choice of faces, up to all six: a closed body tells which way is out.
TEST(OrientFaces, TurnsTheWrongFacesOfACube) {
    for (unsigned wrong = 0; wrong < 64; ++wrong) {
        PolygonMesh mesh = cubeMesh();
        for (std::size_t face = 0; face < 6; ++face)
            if ((wrong >> face & 1) != 0) turn(mesh, face);
        EXPECT_EQ(orient(mesh).turnedFaces, std::popcount(wrong)) << wrong;
        expectOutwards(mesh, {0, 0, 0});
    }
}

TEST(OrientFaces, TurnsACubeFarFromTheOrigin) {
    PolygonMesh mesh = cubeMesh();
    for (glm::dvec3& v : mesh.vertices) v += glm::dvec3(1e6, -2e6, 3e6);
    for (std::size_t face = 0; face < 6; ++face) turn(mesh, face);
    EXPECT_EQ(orient(mesh).turnedFaces, 6);
    expectOutwards(mesh, {1e6, -2e6, 3e6});
}

TEST(OrientFaces, EachBodyOnItsOwn) {
    PolygonMesh mesh = cubeMesh();
    const PolygonMesh second = cubeMesh();
    for (const glm::dvec3& v : second.vertices) mesh.vertices.push_back(v + glm::dvec3(10, 0, 0));
    for (std::vector<int> face : second.faces) {
        for (int& v : face) v += 8;
        mesh.faces.emplace_back(face.rbegin(), face.rend());
    }
    EXPECT_EQ(orient(mesh).turnedFaces, 6);
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const glm::dvec3 centre(i < 6 ? 0 : 10, 0, 0);
        EXPECT_GT(glm::dot(faceNormal(mesh, mesh.faces[i]), mesh.vertices[mesh.faces[i][0]] - centre), 0);
    }
}

TEST(OrientFaces, TurnsABodyOfManyFaces) {
    PolygonMesh mesh = uvSphereMesh(200, 400);
    for (std::size_t face = 0; face < mesh.faces.size(); ++face)
        if (face != 1000) turn(mesh, face);
    EXPECT_EQ(orient(mesh).turnedFaces, static_cast<int>(mesh.faces.size()) - 1);
    expectOutwards(mesh, {0, 0, 0});
}

TEST(OrientFaces, OfAnOpenStripTheFewerAreWrong) {
    for (const std::vector<std::size_t>& wrong : {std::vector<std::size_t>{}, {0}, {4}, {2}, {0, 1}, {1, 3}}) {
        PolygonMesh mesh = strip(5);
        for (const std::size_t face : wrong) turn(mesh, face);
        EXPECT_EQ(orient(mesh).turnedFaces, static_cast<int>(wrong.size()));
        for (const std::vector<int>& face : mesh.faces) EXPECT_GT(faceNormal(mesh, face).z, 0);
    }
}

TEST(OrientFaces, AnOpenStripMayFaceEitherWay) {
    PolygonMesh mesh = strip(5);
    for (std::size_t face = 0; face < 5; ++face)
        if (face != 3) turn(mesh, face);
    EXPECT_EQ(orient(mesh).turnedFaces, 1);
    for (const std::vector<int>& face : mesh.faces) EXPECT_LT(faceNormal(mesh, face).z, 0);
}

TEST(OrientFaces, AnOpenCubeIsWoundAlike) {
    for (std::size_t wrong = 0; wrong < 5; ++wrong) {
        PolygonMesh mesh = cubeMesh();
        mesh.faces.pop_back();
        turn(mesh, wrong);
        EXPECT_EQ(orient(mesh).turnedFaces, 1);
        expectOutwards(mesh, {0, 0, 0});
    }
}

TEST(MakePolyhedron, CountsAllThatItMends) {
    PolygonMesh mesh = cubeMesh();
    mesh.vertices.push_back(mesh.vertices[7]);
    mesh.faces[1] = {4, 5, 8, 8, 6};
    mesh.faces.push_back({0, 1, 1});
    turn(mesh, 0);
    MeshRepairs repairs;
    EXPECT_EQ(Polyhedron::make(mesh, repairs)->triangleCount(), 12u);
    EXPECT_EQ(repairs.mergedVertices, 1);
    EXPECT_EQ(repairs.text(), "1 degenerate vertex dropped, 1 face without area dropped, 1 wrong-way face turned");
}

TEST(MakePolyhedron, OfManyTrianglesHoldsThemAll) {
    MeshRepairs repairs;
    const auto mesh = Polyhedron::make(uvSphereMesh(300, 400), repairs);
    EXPECT_EQ(mesh->triangleCount(), 2u * 400 * 299);
    core::Bounds bounds;
    double area = 0;
    for (std::uint32_t i = 0; i < mesh->triangleCount(); ++i) {
        const core::Vec3f a = mesh->vertex(i, 0), b = mesh->vertex(i, 1), c = mesh->vertex(i, 2);
        for (const core::Vec3f& v : {a, b, c}) bounds.include(v);
        area += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    EXPECT_NEAR(area, 4 * M_PI, 1e-3);
    EXPECT_EQ(mesh->bounds().low, bounds.low);
    EXPECT_EQ(mesh->bounds().high, bounds.high);
}

TEST(MakePolyhedron, NeedsAnArea) {
    MeshRepairs repairs;
    EXPECT_EQ(errorOf([&] {
                  Polyhedron::make({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}}, repairs);
              }),
              "MESH EMPTY [] no face has an area");
    EXPECT_EQ(errorOf([&] {
                  Polyhedron::make({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {}}, repairs);
              }),
              "MESH EMPTY [] no face has an area");
}

}  // namespace
}  // namespace gr
