// Where glTF's nodes, skins and instances place its meshes.
#include "gr/gltf_text.h"

namespace gr {
namespace {

struct GltfSceneTest : GltfTest {
    GltfText text = triangleText();

    Places placed(const std::string& nodes, const std::string& keys = "") {
        text.nodes = nodes;
        text.keys = keys;
        return read(text).vertices;
    }
    std::string refused(const std::string& nodes, const std::string& keys = "") {
        text.nodes = nodes;
        text.keys = keys;
        return reason(text);
    }
};

Places moved(double x, double y, double z) {
    return {{x, y, z}, {x + 1, y, z}, {x, y + 1, z}};
}

void expectNear(const Places& places, const Places& wanted) {
    ASSERT_EQ(places.size(), wanted.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_LT(glm::length(places[i] - wanted[i]), 1e-14)
            << i << ": " << places[i].x << " " << places[i].y << " " << places[i].z;
}

TEST_F(GltfSceneTest, NodesScaleThenTurnThenMove) {
    EXPECT_EQ(placed(R"({"mesh":0,"translation":[1,2,3]})"), moved(1, 2, 3));
    // A quarter turn about z, of a quaternion that is not quite of length 1.
    expectNear(placed(R"({"mesh":0,"translation":[5,0,0],"rotation":[0,0,2,2],"scale":[2,3,1]})"),
               {{5, 0, 0}, {5, 2, 0}, {2, 0, 0}});
    EXPECT_EQ(placed(R"({"mesh":0,"matrix":[2,0,0,0, 0,3,0,0, 0,0,1,0, 7,8,9,1]})"),
              (Places{{7, 8, 9}, {9, 8, 9}, {7, 11, 9}}));
    EXPECT_EQ(placed(R"({"children":[1],"scale":[2,2,2]},{"children":[2],"translation":[1,0,0]},{"mesh":0})"),
              (Places{{2, 0, 0}, {4, 0, 0}, {2, 2, 0}}));
    EXPECT_EQ(refused(R"({"mesh":0,"translation":[1,2]})"), "its node 0's \"translation\" has 2 numbers instead of 3");
    EXPECT_EQ(refused(R"({"mesh":0,"scale":[1,2,"a"]})"), "its node 0's \"scale\" is not a list of numbers");
    EXPECT_EQ(refused(R"({"mesh":0,"rotation":[0,0,0,0]})"), "its node 0 has the rotation 0 0 0 0, which is none");
}

TEST_F(GltfSceneTest, MirroredFacesAreTurned) {
    text.addVectors({0, 0.6f, 0.8f, 0, 0.6f, 0.8f, 0, 0.6f, 0.8f});
    text.primitives = R"({"attributes":{"POSITION":0,"NORMAL":1}})";
    text.nodes = R"({"mesh":0,"scale":[-1,1,1]})";
    importer::SourceMesh mesh = read(text);
    EXPECT_EQ(faceOf(mesh, 0), (Places{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}));
    EXPECT_EQ(mesh.normals[0], packNormal({0, 0.6f, 0.8f}));
    // Upside down.
    text.nodes = R"({"mesh":0,"scale":[1,1,-1]})";
    mesh = read(text);
    EXPECT_EQ(faceOf(mesh, 0), (Places{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_EQ(mesh.normals[0], packNormal({0, 0.6f, -0.8f}));
    // Normals of what is stretched are turned away from there.
    text.nodes = R"({"mesh":0,"scale":[1,2,1]})";
    EXPECT_EQ(read(text).normals[0], packNormal({0, 0.3f, 0.8f}));
}

TEST_F(GltfSceneTest, TheDefaultSceneIsRead) {
    const std::string nodes = R"({"mesh":0},{"mesh":0,"translation":[1,0,0]},{"mesh":0,"translation":[2,0,0]})",
                      scenes = R"(,"scenes":[{"nodes":[1]},{"nodes":[2]}])";
    EXPECT_EQ(placed(nodes, scenes + R"(,"scene":1)"), moved(2, 0, 0));
    EXPECT_EQ(placed(nodes, scenes), moved(1, 0, 0));
    EXPECT_EQ(placed(nodes).size(), 9u);
    EXPECT_EQ(refused(nodes, R"(,"scenes":[{}])"), "it has no faces");
    EXPECT_EQ(refused(nodes, R"(,"scenes":[{"nodes":[3]}])"), "its scene 0 names node 3 of 3");
    EXPECT_EQ(refused(nodes, R"(,"scenes":[{"nodes":[1,1]}])"), "its scene 0 names node 1 twice");
    EXPECT_EQ(refused(R"({"children":[1]},{"mesh":0})", R"(,"scenes":[{"nodes":[1]}])"),
              "its scene 0 names node 1, which is a child of node 0");
}

TEST_F(GltfSceneTest, NodesAreATree) {
    EXPECT_EQ(refused(R"({"mesh":0,"children":[0]})"), "its node 0 is below itself");
    EXPECT_EQ(refused(R"({"children":[1]},{"children":[0]},{"mesh":0})"), "its node 1 is below itself");
    EXPECT_EQ(refused(R"({"children":[2]},{"children":[2]},{"mesh":0})"),
              "its node 2 is a child of node 0 and of node 1");
    EXPECT_EQ(refused(R"({"children":[1,1]},{"mesh":0})"), "its node 1 is a child of node 0 and of node 0");
    std::string chain;
    constexpr int depth = 100'000;
    for (int i = 1; i < depth; ++i) chain += R"({"translation":[1,0,0],"children":[)" + std::to_string(i) + "]},";
    EXPECT_EQ(placed(chain + R"({"mesh":0})"), moved(depth - 1, 0, 0));
}

TEST_F(GltfSceneTest, MorphTargetsAreAddedByWeight) {
    text.addVectors({0, 0, 0, 0, 0, 2, 0, 4, 0});
    text.addVectors({8, 0, 0, 0, 0, 0, 0, 0, 0});
    text.addVectors({0, 0, 1, 0, 0, 1, 0, 0, 1});
    text.addVectors({0, 1, 0, 0, 0, 0, 0, 1, -1});
    text.primitives = R"({"attributes":{"POSITION":0,"NORMAL":3},)"
                      R"("targets":[{"POSITION":1,"NORMAL":4},{"POSITION":2}]})";
    const Places plain = moved(0, 0, 0);
    EXPECT_EQ(placed(R"({"mesh":0})"), plain);
    text.meshKeys = R"(,"weights":[0.5,0])";
    EXPECT_EQ(placed(R"({"mesh":0})"), (Places{{0, 0, 0}, {1, 0, 1}, {0, 3, 0}}));
    EXPECT_EQ(read(text).normals,
              (std::vector{packNormal({0, 0.5f, 1}), packNormal({0, 0, 1}), packNormal({0, 1, 1})}));
    // Each node has its own.
    EXPECT_EQ(
        placed(R"({"mesh":0,"weights":[0,0.25]},{"mesh":0},{"mesh":0,"weights":[]})"),
        (Places{{2, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 1}, {0, 3, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    text.primitives = R"({"attributes":{"POSITION":0},"targets":[{"POSITION":9}]})";
    EXPECT_EQ(refused(R"({"mesh":0})"), "its mesh 0's primitive 0's target 0 names accessor 9 of 5");
}

std::string matrix(float scale, float x) {
    return bytesOf(scale, 0.f, 0.f, 0.f, 0.f, scale, 0.f, 0.f, 0.f, 0.f, scale, 0.f, x, 0.f, 0.f, 1.f);
}

// Vertex 0 is joint 0's, vertex 1 joint 1's, vertex 2 half of each.
struct GltfSkinTest : GltfSceneTest {
    GltfSkinTest() {
        text.add("VEC4", 5121, 3, std::string("\0\1\0\0\0\1\0\0\1\0\7\7", 12));
        text.add("VEC4", 5121, 3, std::string("\xff\0\0\0\0\xff\0\0\x33\x33\0\0", 12), R"(,"normalized":true)");
        text.add("MAT4", 5126, 2, matrix(1, -10) + matrix(2, 0));
        text.primitives = R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}})";
    }
    std::string nodes =
        R"({"mesh":0,"skin":0,"translation":[100,0,0]},{"translation":[10,0,5],"children":[2]},{"translation":[0,0,2]})";
    std::string skin = R"(,"skins":[{"joints":[1,2],"inverseBindMatrices":3}])";
};

TEST_F(GltfSkinTest, JointsPlaceVertices) {
    expectNear(placed(nodes, skin), {{0, 0, 5}, {12, 0, 7}, {5, 1.5, 6}});
    expectNear(placed(nodes, R"(,"skins":[{"joints":[1,2]}])"), {{10, 0, 5}, {11, 0, 7}, {10, 1, 6}});
}

TEST_F(GltfSkinTest, MoreJointsOfAVertexAreInMoreSets) {
    text.add("VEC4", 5123, 3, std::string(24, '\0'));
    text.addFloats("VEC4", 4, {0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0});
    text.primitives = R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2,"JOINTS_1":4,"WEIGHTS_1":5}})";
    expectNear(placed(nodes, skin), {{0, 0, 5}, {6.5, 0, 6}, {5, 1.5, 6}});
}

TEST_F(GltfSkinTest, VerticesWithoutWeightAreTheFirstJoints) {
    text.addFloats("VEC4", 4, std::vector<float>(12, 0));
    text.primitives = R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":4}})";
    expectNear(placed(nodes, skin), {{0, 0, 5}, {1, 0, 5}, {10, 2, 7}});
}

TEST_F(GltfSkinTest, MirroringJointsTurnFaces) {
    text.nodes = R"({"mesh":0,"skin":0,"scale":[-1,1,1]},{"scale":[1,1,-1]},{"scale":[1,1,-1]})";
    text.keys = R"(,"skins":[{"joints":[1,2]}])";
    EXPECT_EQ(faceOf(read(text), 0), (Places{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}));
}

TEST_F(GltfSkinTest, BrokenSkinsAreTold) {
    EXPECT_EQ(refused(nodes), "its node 0 names skin 0 of 0");
    EXPECT_EQ(refused(nodes, R"(,"skins":[{"joints":[1]}])"), "its mesh 0's primitive 0 names joint 1 of 1");
    EXPECT_EQ(refused(nodes, R"(,"skins":[{"joints":[1,4]}])"), "its skin 0 names node 4 of 3");
    EXPECT_EQ(refused(nodes, R"(,"skins":[{"joints":[1,2,0],"inverseBindMatrices":3}])"),
              "its skin 0 has 3 joints, but inverseBindMatrices for 2");
    EXPECT_EQ(refused(nodes, R"(,"skins":[{"joints":[1,2],"inverseBindMatrices":0}])"),
              "its accessor 0 is VEC3, but inverseBindMatrices is MAT4");
    text.primitives = R"({"attributes":{"POSITION":0,"JOINTS_0":1}})";
    EXPECT_EQ(refused(nodes, skin), "its mesh 0's primitive 0 has only one of JOINTS_0 and WEIGHTS_0");
}

const std::string instancing =
    R"({"mesh":0,"translation":[0,0,1],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":)";

TEST_F(GltfSceneTest, InstancesStandBelowTheirNode) {
    text.addVectors({5, 0, 0, 0, 5, 0});
    text.addVectors({1, 1, 1, 2, -2, 2});
    text.add("VEC4", 5122, 2, bytesOf(std::int64_t{0x7fff} << 48, std::int64_t{0x7fff} << 32), R"(,"normalized":true)");
    text.nodes = instancing + R"({"TRANSLATION":1,"SCALE":2,"ROTATION":3,"_OTHER":1}}}})";
    const importer::SourceMesh mesh = read(text);
    expectNear(mesh.vertices, {{5, 0, 1}, {6, 0, 1}, {5, 1, 1}, {0, 5, 1}, {-2, 5, 1}, {0, 7, 1}});
    EXPECT_EQ(mesh.corners, (std::vector{0, 1, 2, 3, 5, 4}));
    EXPECT_EQ(mesh.groups.size(), 2u);
}

TEST_F(GltfSceneTest, BrokenInstancesAreTold) {
    text.addVectors({5, 0, 0, 0, 5, 0});
    const std::string place = "its node 0's EXT_mesh_gpu_instancing";
    EXPECT_EQ(refused(instancing + R"({"TRANSLATION":1,"SCALE":0}}}})"),
              place + " has 2 of TRANSLATION for 3 of others");
    EXPECT_EQ(refused(instancing + R"({"ROTATION":1}}}})"), "its accessor 1 is VEC3, but ROTATION is VEC4");
    EXPECT_EQ(refused(instancing + R"({}}}})"), place + " has no \"attributes\"");
    // Sixteen million times a mesh of more than forty triangles.
    text = {};
    text.addVectors(std::vector<float>(9 * 43, 0));
    text.addAccessor("VEC3", 5126, 1 << 24, "");
    text.primitives = R"({"attributes":{"POSITION":0}})";
    EXPECT_EQ(refused(instancing + R"({"TRANSLATION":1}}}})"), "its faces have more than 2147483647 corners in all");
}

TEST_F(GltfSceneTest, LinesOfInstancesAreCounted) {
    text.addVectors({5, 0, 0, 0, 5, 0});
    text.primitives = R"({"attributes":{"POSITION":0},"mode":2},{"attributes":{"POSITION":0}})";
    text.nodes = instancing + R"({"TRANSLATION":1}}}})";
    EXPECT_EQ(read(text).linesAndPoints, 6u);
}

}  // namespace
}  // namespace gr
