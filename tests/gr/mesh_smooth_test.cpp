// Normals that are made from faces.
// Seen to fail with faces that all count alike, with the wrong side of dented corners, with every edge
// smooth or sharp, and with edges that three faces share.
#include "gr/mesh/mesh_smooth.h"
#include "gr/cube_mesh.h"

#include "gr/mesh/mesh_repair.h"
#include "gr/uv_sphere_mesh.h"

#include <gtest/gtest.h>
#include <chrono>

namespace gr {
namespace {

constexpr double packing = 1e-4;  // what a packed normal is off by, at most

FlatMesh smooth(const PolygonMesh& given, double degrees) {
    FlatMesh mesh(given);
    smoothNormals(mesh, degrees);
    return mesh;
}

// Calls function(vertex's place, its normal, the face's normal) for each corner.
template<class Function>
void forEachCorner(const FlatMesh& mesh, Function&& function) {
    ASSERT_EQ(mesh.normals.size(), mesh.corners.size());
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int place = mesh.begin(f); place < mesh.end(f); ++place)
            function(mesh.vertices[mesh.corners[place]], glm::dvec3(unpackNormal(mesh.normals[place])),
                     glm::normalize(faceNormal(mesh.vertices, mesh.face(f))));
}

void expectFlat(const FlatMesh& mesh) {
    forEachCorner(mesh, [](const glm::dvec3&, const glm::dvec3& normal, const glm::dvec3& ofFace) {
        EXPECT_LT(glm::distance(normal, ofFace), packing);
    });
}

TEST(SmoothNormals, OfACubeAreItsFacesBelowARightAngle) {
    expectFlat(smooth(cubeMesh(), 40));
    expectFlat(smooth(cubeMesh(), 90));
}

// Whichever way its faces are cut, also only some of them.
TEST(SmoothNormals, OfACubePointToItsCornersAboveARightAngle) {
    for (unsigned cut = 0; cut < 64; ++cut) {
        PolygonMesh mesh = cubeMesh();
        for (std::size_t f = 0; f < 6; ++f) {
            if ((cut >> f & 1) == 0) continue;
            const std::vector<int> face = mesh.faces[f];
            mesh.faces[f] = {face[0], face[1], face[2]};
            mesh.faces.push_back({face[0], face[2], face[3]});
        }
        forEachCorner(smooth(mesh, 100), [&](const glm::dvec3& place, const glm::dvec3& normal, const glm::dvec3&) {
            EXPECT_LT(glm::distance(normal, glm::normalize(place)), packing) << cut;
        });
    }
}

TEST(SmoothNormals, AreLeftAsTheyAre) {
    FlatMesh mesh(cubeMesh());
    smoothNormals(mesh, 0);
    EXPECT_TRUE(mesh.normals.empty());
    mesh.normals.assign(mesh.corners.size(), packNormal({0, 0, 1}));
    const auto before = mesh.normals;
    smoothNormals(mesh, 40);
    EXPECT_EQ(mesh.normals, before);
}

TEST(SmoothNormals, OfACylinderAreRoundOnItsSideAndFlatOnItsCaps) {
    constexpr int sides = 20;
    PolygonMesh mesh;
    std::vector<int> low, high;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * M_PI * i / sides;
        for (const double y : {0., 1.}) mesh.vertices.emplace_back(std::cos(angle), y, -std::sin(angle));
        const int next = (i + 1) % sides;
        mesh.faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
        high.push_back(2 * i + 1);
        low.insert(low.begin(), 2 * i);
    }
    mesh.faces.push_back(low);
    mesh.faces.push_back(high);
    forEachCorner(smooth(mesh, 40), [](const glm::dvec3& place, const glm::dvec3& normal, const glm::dvec3& ofFace) {
        const bool isCap = std::abs(ofFace.y) > 0.5;
        EXPECT_LT(glm::distance(normal, isCap ? ofFace : glm::dvec3(place.x, 0, place.z)), packing);
    });
    expectFlat(smooth(mesh, 17.9));  // 18 degrees from side to side
}

TEST(SmoothNormals, OfABallAreNearlyRadial) {
    forEachCorner(smooth(uvSphereMesh(32, 64), 40),
                  [](const glm::dvec3& place, const glm::dvec3& normal, const glm::dvec3&) {
                      EXPECT_LT(glm::distance(normal, place), 0.002);
                  });
}

// Three walls that meet in one edge stay apart, though the angles between them are small.
TEST(SmoothNormals, StopAtAnEdgeOfThreeFaces) {
    PolygonMesh mesh{
        {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0.1}, {-1, 1, 0.1}, {-1, 0, -0.1}, {-1, 1, -0.1}},
        {{0, 2, 3, 1}, {4, 0, 1, 5}, {6, 0, 1, 7}}};
    expectFlat(smooth(mesh, 40));
    mesh.faces.pop_back();
    forEachCorner(smooth(mesh, 40), [](const glm::dvec3& place, const glm::dvec3& normal, const glm::dvec3& ofFace) {
        EXPECT_EQ(glm::distance(normal, ofFace) > 0.01, place.x == 0);
    });
}

// A roof over an L: at the dented corner its floor counts by three quarters of a turn.
TEST(SmoothNormals, CountADentedCornerByItsInnerAngle) {
    const PolygonMesh mesh{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {2, 2, 0.5}},
                           {{0, 1, 2, 3, 4, 5}, {3, 2, 6}}};
    const glm::dvec3 other = glm::normalize(faceNormal(mesh.vertices, mesh.faces[1]));
    const glm::dvec3 a(1, 0, 0), b = glm::normalize(glm::dvec3(1, 1, 0.5));
    const glm::dvec3 expected = glm::normalize(1.5 * M_PI * glm::dvec3(0, 0, 1) + std::acos(glm::dot(a, b)) * other);
    forEachCorner(smooth(mesh, 80), [&](const glm::dvec3& place, const glm::dvec3& normal, const glm::dvec3&) {
        if (place == mesh.vertices[3]) {
            EXPECT_LT(glm::distance(normal, expected), packing);
        }
    });
}

TEST(SmoothNormals, AreThoseOfThePolyhedron) {
    MeshRepairs repairs;
    EXPECT_FALSE(Polyhedron::make(FlatMesh(uvSphereMesh(8, 16)), repairs)->hasNormals());
    EXPECT_TRUE(Polyhedron::make(FlatMesh(uvSphereMesh(8, 16)), repairs, 40)->hasNormals());
    EXPECT_FALSE(Polyhedron::make(FlatMesh(cubeMesh()), repairs, 40)->hasNormals());
}

TEST(SmoothNormals, OfAMillionTrianglesTakeLittleTime) {
    FlatMesh mesh(uvSphereMesh(500, 1000));
    const auto start = std::chrono::steady_clock::now();
    smoothNormals(mesh, 40);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    EXPECT_LT(time.count(), 5);
    RecordProperty("seconds", std::to_string(time.count()));
}

TEST(SmoothNormals, OfAConeOfManySidesTakeLittleTime) {
    PolygonMesh mesh;
    constexpr int sides = 200'000;
    mesh.vertices.emplace_back(0, 1, 0);
    for (int i = 0; i < sides; ++i) {
        mesh.vertices.emplace_back(std::cos(2 * M_PI * i / sides), 0, -std::sin(2 * M_PI * i / sides));
        mesh.faces.push_back({0, 1 + i, 1 + (i + 1) % sides});
    }
    const auto start = std::chrono::steady_clock::now();
    forEachCorner(smooth(mesh, 40), [](const glm::dvec3& place, const glm::dvec3& normal, const glm::dvec3&) {
        if (place.y == 1) {
            EXPECT_LT(glm::distance(normal, glm::dvec3(0, 1, 0)), packing);
        }
    });
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

}  // namespace
}  // namespace gr
