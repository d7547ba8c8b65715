// A mesh whose normals are its faces' is a flat mesh, whatever rounding has made of them; one that is shaded as
// something rounder keeps them.
// Seen to fail with each triangle's normals held against its own face alone, without what rounding does to thin
// triangles, with normals that may differ from each other by five degrees, and with leaning ones that count as flat.
#include "gr/mesh_text.h"
#include "gr/random_shapes.h"

#include <gtest/gtest.h>

namespace gr {
namespace {

using core::Vec3f;

std::shared_ptr<const Polyhedron> made(FlatMesh mesh) {
    MeshRepairs repairs;
    return Polyhedron::make(std::move(mesh), repairs);
}

// The face's area, along its normal, also where it is not plane.
glm::dvec3 areaOf(const PolygonMesh& mesh, const std::vector<int>& face) {
    glm::dvec3 area(0);
    for (std::size_t i = 0; i < face.size(); ++i)
        area += glm::cross(mesh.vertices[face[i]], mesh.vertices[face[(i + 1) % face.size()]]);
    return area;
}

// Each corner with the normal of its face, to some digits; lean: is added to each.
FlatMesh flatShaded(const PolygonMesh& given, double digits = 1e-4, const glm::dvec3& lean = glm::dvec3(0)) {
    FlatMesh mesh(given);
    for (const std::vector<int>& face : given.faces) {
        const glm::dvec3 normal = glm::normalize(areaOf(given, face)) + lean;
        for (std::size_t i = 0; i < face.size(); ++i)
            mesh.normals.push_back(packNormal(Vec3f(glm::round(normal / digits) * digits)));
    }
    return mesh;
}

PolygonMesh moved(PolygonMesh mesh, const std::function<glm::dvec3(const glm::dvec3&)>& move) {
    for (glm::dvec3& v : mesh.vertices) v = move(v);
    return mesh;
}

glm::dvec3 turned(const glm::dvec3& v) {
    return {0.6 * v.x - 0.8 * v.y, 0.48 * v.x + 0.36 * v.y - 0.8 * v.z, 0.64 * v.x + 0.48 * v.y + 0.6 * v.z};
}

TEST(FlatNormals, AreRoundedToSomeDigits) {
    const PolygonMesh cube = moved(cubeMesh(), turned);
    for (const double digits : {1e-2, 1e-3, 1e-4, 1e-6}) EXPECT_FALSE(made(flatShaded(cube, digits))->hasNormals());
    EXPECT_FALSE(made(flatShaded(moved(icosphereMesh(1), turned), 1e-2))->hasNormals());
}

TEST(FlatNormals, AreThoseOfQuadsThatAreNotQuitePlane) {
    support::TestRandom random(1);
    for (const double by : {1e-4, 1e-3, 1e-2, 3e-2}) {
        const PolygonMesh cube =
            moved(cubeMesh(), [&](const glm::dvec3& v) { return turned(v) + randomPoint(random, -by, by); });
        EXPECT_FALSE(made(flatShaded(cube))->hasNormals()) << by;
    }
}

// Vertices so near to a line, or so far away, that their digits do not tell how the triangle lies.
TEST(FlatNormals, AreThoseOfFacesThatRoundingTurns) {
    PolygonMesh sliver = moved(cubeMesh(), turned);
    FlatMesh mesh = flatShaded(sliver);
    const glm::dvec3 a = sliver.vertices[0], b = sliver.vertices[1];
    const int tip = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back((a + b) * 0.5 + 1e-6 * turned({0.3, 0.5, 0.8}));
    for (const int vertex : {0, 1, tip}) {
        mesh.corners.push_back(vertex);
        mesh.normals.push_back(mesh.normals[0]);
    }
    mesh.ends.push_back(static_cast<int>(mesh.corners.size()));
    EXPECT_FALSE(made(mesh)->hasNormals());

    FlatMesh far = flatShaded(sliver);
    for (glm::dvec3& v : far.vertices) v = glm::dvec3(Vec3f(v + glm::dvec3(1e6, 2e6, 5e5)));
    EXPECT_FALSE(made(far)->hasNormals());
}

TEST(SmoothNormals, AreKept) {
    for (const int cuts : {0, 1, 2, 3, 4, 5}) {
        const PolygonMesh ball = icosphereMesh(cuts);
        FlatMesh mesh(ball);
        for (const int corner : mesh.corners) mesh.normals.push_back(packNormal(Vec3f(mesh.vertices[corner])));
        EXPECT_TRUE(made(mesh)->hasNormals()) << cuts;
    }
}

// All of a leaf's alike, but not its face's; and one corner of many that is shaded with another normal.
TEST(SmoothNormals, MayBeFew) {
    const PolygonMesh cube = moved(cubeMesh(), turned);
    EXPECT_TRUE(made(flatShaded(cube, 1e-4, glm::dvec3(0.1, 0.1, 0.1)))->hasNormals());
    FlatMesh mesh = flatShaded(cube);
    mesh.normals[7] = packNormal(unpackNormal(mesh.normals[7]) + Vec3f(0.02f, -0.03f, 0.01f));
    EXPECT_TRUE(made(mesh)->hasNormals());
}

// The block of mesh_text.h, each face's corners with its normal.
struct FlatFiles : testing::Test {
    MeshFolder folder;
    MeshFiles files;

    bool hasNormals(const std::string& name, const std::string& bytes) {
        MeshRepairs repairs;
        const auto mesh = files.read(folder.write(name, bytes), name, repairs);
        EXPECT_EQ(mesh->triangleCount(), 12u);
        return mesh->hasNormals();
    }
    // lean: is added to a corner's normal.
    static Vec3f normalOf(const int (&face)[4], float lean) {
        const auto at = [&](int i) {
            return Vec3f(blockVertices[face[i]][0], blockVertices[face[i]][1], blockVertices[face[i]][2]);
        };
        return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0))) + Vec3f(lean);
    }
    static std::string obj(float lean) {
        std::string text;
        for (const auto& v : blockVertices) text += "v " + vertexText(v);
        for (const auto& f : blockFaces)
            for (int i = 0; i < 4; ++i) text += "vn " + vertexText(&normalOf(f, i == 1 ? lean : 0)[0]);
        int normal = 0;
        for (const auto& f : blockFaces) {
            text += "f";
            for (const int i : f) text += " " + std::to_string(i + 1) + "//" + std::to_string(++normal);
            text += "\n";
        }
        return text;
    }
    static std::string ply(float lean) {
        std::string text = "ply\nformat ascii 1.0\nelement vertex 24\n";
        for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) text += std::string("property float ") + name + "\n";
        text += "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
        for (const auto& f : blockFaces)
            for (int i = 0; i < 4; ++i) {
                std::string vertex = vertexText(blockVertices[f[i]]);
                vertex.back() = ' ';
                text += vertex + vertexText(&normalOf(f, i == 1 ? lean : 0)[0]);
            }
        for (int i = 0; i < 24; i += 4)
            text += "4 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + " " +
                    std::to_string(i + 3) + "\n";
        return text;
    }
    std::string gltf(float lean) {
        std::string places, normals;
        for (const auto& f : blockFaces)
            for (const auto& cut : blockCuts)
                for (const int i : cut) {
                    places += bytesOf(blockVertices[f[i]]);
                    normals += bytesOf(normalOf(f, i == 1 ? lean : 0));
                }
        folder.write("flat.bin", places + normals);
        return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{)"
               R"("primitives":[{"attributes":{"POSITION":0,"NORMAL":1}}]}],"buffers":[{"byteLength":864,)"
               R"("uri":"flat.bin"}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":432},)"
               R"({"buffer":0,"byteOffset":432,"byteLength":432}],"accessors":[{"bufferView":0,"componentType":5126,)"
               R"("count":36,"type":"VEC3"},{"bufferView":1,"componentType":5126,"count":36,"type":"VEC3"}]})";
    }
};

TEST_F(FlatFiles, HaveNoNormalsInAnyFormat) {
    EXPECT_FALSE(hasNormals("a.obj", obj(0)));
    EXPECT_FALSE(hasNormals("a.ply", ply(0)));
    EXPECT_FALSE(hasNormals("a.gltf", gltf(0)));
    EXPECT_TRUE(hasNormals("b.obj", obj(0.1f)));
    EXPECT_TRUE(hasNormals("b.ply", ply(0.1f)));
    EXPECT_TRUE(hasNormals("b.gltf", gltf(0.1f)));
}

}  // namespace
}  // namespace gr
