// Meshes from files, good ones and broken ones. Messages are compared word for word.
#include "gr/accelerators/accelerator.h"
#include "gr/error_of.h"
#include "gr/mesh/mesh_import.h"
#include "gr/mesh/polyhedron_surface.h"
#include "gr/mesh_text.h"
#include "gr/scene.h"
#include "support/test_random.h"

#include <fcntl.h>

#include <map>
#include <thread>

namespace gr {
namespace {

struct MeshFileTest : testing::Test {
    MeshFolder folder;
    MeshFiles files;
    MeshRepairs repairs;

    std::shared_ptr<const Polyhedron> read(const std::string& name, const std::string& bytes) {
        repairs = {};
        return files.read(folder.write(name, bytes), name, repairs);
    }
    // What is wrong with a file. Its place is the errorCode's word.
    std::string reason(const std::string& name, const std::string& bytes) {
        const std::string error = errorOf([&] { read(name, bytes); });
        const std::string start = "MESH FILE [" + folder / name + "] cannot read \"" + name + "\": ";
        return error.starts_with(start) ? error.substr(start.size()) : "not \"" + start + "\" but " + error;
    }
};

void expectBlock(const Polyhedron& mesh, const core::Vec3f& low, const core::Vec3f& high) {
    EXPECT_EQ(mesh.triangleCount(), 12u);
    EXPECT_EQ(mesh.bounds().low, low);
    EXPECT_EQ(mesh.bounds().high, high);
    EXPECT_FALSE(mesh.hasNormals());
    for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i) {
        const core::Vec3f a = mesh.vertex(i, 0), b = mesh.vertex(i, 1), c = mesh.vertex(i, 2);
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a - (low + high) * 0.5f), 0) << "triangle " << i;
    }
}

TEST_F(MeshFileTest, EveryFormatGivesTheSameBlock) {
    const std::string buffer = blockBuffer(), external = R"(,"uri":"block.bin")";
    folder.write("block.bin", buffer);
    for (const auto& [name, bytes] : std::initializer_list<std::pair<std::string, std::string>>{
             {"a.obj", blockObj()},
             {"b.ply", blockPly()},
             {"c.ply", blockBinaryPly()},
             {"d.stl", blockStl()},
             {"e.STL", blockBinaryStl()},
             {"f.glb", blockGlb()},
             {"g.gltf", blockGltf(R"([{"mesh":0}])", external)}}) {
        SCOPED_TRACE(name);
        expectBlock(*read(name, bytes), {0, 0, 0}, {1, 2, 3});
        EXPECT_EQ(repairs.text(), "");
    }
}

TEST_F(MeshFileTest, GltfNodesPlaceTheirMeshes) {
    folder.write("block.bin", blockBuffer());
    const std::string uri = R"(,"uri":"block.bin")";
    // Mirrored, too: its faces still face outwards.
    const std::string nodes = R"([{"children":[1],"translation":[5,0,0]},{"mesh":0,"scale":[-2,1,1]}])";
    expectBlock(*read("a.gltf", blockGltf(nodes, uri)), {3, 0, 0}, {5, 2, 3});
    EXPECT_EQ(repairs.text(), "");
    const auto two =
        read("b.gltf", blockGltf(R"([{"children":[1,2]},{"mesh":0},{"mesh":0,"translation":[9,9,9]}])", uri));
    EXPECT_EQ(two->triangleCount(), 24u);
    EXPECT_EQ(two->bounds().high, core::Vec3f(10, 11, 12));
}

TEST_F(MeshFileTest, SeveralObjectsAreOneMesh) {
    const std::string second = "o other\nv 5 5 5\nv 6 5 5\nv 5 6 5\nf -3 -2 -1\n";
    EXPECT_EQ(read("a.obj", "o first\n" + blockObj() + second)->triangleCount(), 13u);
    EXPECT_EQ(repairs.text(), "");
}

TEST_F(MeshFileTest, CutsPolygonsItself) {
    const std::string arrow = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n";
    const auto mesh = read("a.obj", arrow);
    EXPECT_EQ(mesh->triangleCount(), 2u);
    double area = 0;
    for (std::uint32_t i = 0; i < 2; ++i)
        area +=
            glm::length(glm::cross(mesh->vertex(i, 1) - mesh->vertex(i, 0), mesh->vertex(i, 2) - mesh->vertex(i, 0)));
    EXPECT_EQ(area / 2, 4);
}

TEST_F(MeshFileTest, VerticesAtOnePlaceAreOne) {
    support::TestRandom random(1);
    // 12 places, which come again soon and late; 0 and -0 are one.
    std::vector<core::Vec3f> places;
    std::string text;
    for (int i = 0; i < 3000; ++i) {
        const int number = static_cast<int>(random.nextBits() % (i < 1500 ? 4 : 12));
        places.emplace_back(number % 2, number / 2, number % 3);
        text += "v " + std::string(number % 2 == 0 && i % 2 == 0 ? "-0" : std::to_string(number % 2)) + " " +
                std::to_string(number / 2) + " " + std::to_string(number % 3) + "\n";
        if (i % 3 == 2)
            text += "f " + std::to_string(i - 1) + " " + std::to_string(i) + " " + std::to_string(i + 1) + "\n";
    }
    const core::Descriptor file(open(folder.write("a.obj", text).c_str(), O_RDONLY)),
        below(open(std::string(folder / "").c_str(), O_PATH | O_DIRECTORY));
    const FlatMesh mesh = importMesh(file.number(), ".obj", below.number(), repairs).mesh;
    EXPECT_EQ(mesh.vertices.size(), 12u);
    ASSERT_EQ(mesh.corners.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_EQ(core::Vec3f(mesh.vertices[mesh.corners[i]]), places[i]) << "corner " << i;
}

TEST_F(MeshFileTest, CountsWhatItMends) {
    const auto repairsOf = [&](const std::string& more) {
        EXPECT_EQ(read("a.obj", blockObj() + more)->triangleCount(), 12u) << more;
        return repairs.text();
    };
    EXPECT_EQ(repairsOf("f 1 1 2\nf 1 2 1 3\n"), "2 faces without area dropped");
    EXPECT_EQ(repairsOf("v 9 0 0\nv 13 0 0\nv 9 1 0\nv 13 2 0\nf 9 10 11 12\n"), "1 self-crossing face dropped");
    EXPECT_EQ(repairsOf("l 1 2\n"), "1 line or point left out");
    std::string wrong = blockObj();
    wrong.replace(wrong.find("f 1 4 3 2"), 9, "f 2 3 4 1");
    EXPECT_EQ(read("b.obj", wrong)->triangleCount(), 12u);
    EXPECT_EQ(repairs.text(), "1 wrong-way face turned");
}

TEST_F(MeshFileTest, AFileReadTwiceIsKeptOnce) {
    const auto first = read("a.obj", blockObj() + "f 1 1 2\n");
    std::filesystem::create_symlink("a.obj", folder / "link.obj");
    std::filesystem::create_directory(folder / "inner");
    for (const char* name : {"a.obj", "link.obj", "inner/../a.obj"}) {
        repairs = {};
        EXPECT_EQ(files.read(folder / name, name, repairs), first);
        EXPECT_EQ(repairs.text(), "") << "a warning once is enough";
    }
    EXPECT_NE(read("b.obj", blockObj()), first);
}

TEST_F(MeshFileTest, AFileThatHasChangedIsReadAgain) {
    const auto first = read("a.obj", blockObj());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")->triangleCount(), 1u);
    EXPECT_EQ(first->triangleCount(), 12u);
}

TEST_F(MeshFileTest, NormalsAreKeptWhereTheyAreNotTheFaces) {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    const auto normal = [](const Polyhedron& mesh, float b1, float b2) {
        return glm::normalize(mesh.shadingNormal<float>({.t = 1, .triangle = 0, .b1 = b1, .b2 = b2}));
    };
    const auto flat = read("flat.obj", square + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n");
    EXPECT_FALSE(flat->hasNormals());
    const auto smooth = read("smooth.obj", square + "vn 0 0 5\nvn 1 0 1\nvn 0 1 1\nf 1//1 2//2 3//3\n");
    ASSERT_TRUE(smooth->hasNormals());
    EXPECT_LT(glm::distance(normal(*smooth, 0, 0), {0, 0, 1}), 1e-4f);
    EXPECT_LT(glm::distance(normal(*smooth, 1, 0), glm::normalize(core::Vec3f(1, 0, 1))), 1e-4f);
    EXPECT_LT(glm::distance(normal(*smooth, 0, 1), glm::normalize(core::Vec3f(0, 1, 1))), 1e-4f);
    // Inwards ones are turned with their face's, those without a direction are the face's.
    const auto inwards = read("inwards.obj", square + "vn 0 0 -1\nvn -1 0 -1\nvn 0 0 0\nf 1//1 2//2 3//3\n");
    EXPECT_LT(glm::distance(normal(*inwards, 1, 0), glm::normalize(core::Vec3f(1, 0, 1))), 1e-4f);
    EXPECT_LT(glm::distance(normal(*inwards, 0, 1), {0, 0, 1}), 1e-4f);
}

TEST(PackedNormal, IsTheDirection) {
    support::TestRandom random(1);
    for (int i = 0; i < 100000; ++i) {
        core::Vec3f v(random.next() - 0.5, random.next() - 0.5, random.next() - 0.5);
        if (i < 27) v = core::Vec3f(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (v == core::Vec3f(0)) continue;
        EXPECT_NE(packNormal(v), noNormal);
        EXPECT_LT(glm::distance(unpackNormal(packNormal(v)), glm::normalize(v)), 7e-5f);
    }
}

TEST_F(MeshFileTest, AMillionTrianglesWouldTakeFewBytes) {
    std::string text;
    constexpr int side = 100;
    for (int i = 0; i < side * side; ++i)
        text += "v " + std::to_string(i % side) + " " + std::to_string(i / side) + " 0\nvn 0 " + std::to_string(i % 2) +
                " 1\n";
    for (int y = 1; y < side; ++y)
        for (int x = 1; x < side; ++x)
            for (const std::array<int, 3>& t : {std::array{0, 1, side + 1}, std::array{0, side + 1, side}}) {
                text += "f";
                for (const int offset : t) {
                    const std::string number = std::to_string((y - 1) * side + x + offset);
                    text += " " + number + "//" + number;
                }
                text += "\n";
            }
    const auto mesh = read("a.obj", text);
    ASSERT_EQ(mesh->triangleCount(), 19602u);
    EXPECT_TRUE(mesh->hasNormals());
    EXPECT_LE(mesh->bytes(), 60 * mesh->triangleCount());
}

TEST_F(MeshFileTest, FilesThatCannotBeRead) {
    EXPECT_EQ(errorOf([&] { files.read(folder / "a.obj", "a.obj", repairs); }),
              "MESH FILE [" + folder / "a.obj" + "] cannot read \"a.obj\": no such file or directory");
    std::filesystem::create_directory(folder / "folder.ply");
    EXPECT_EQ(errorOf([&] { files.read(folder / "folder.ply", "f", repairs); }),
              "MESH FILE [" + folder / "folder.ply" + "] cannot read \"f\": is a directory");
    EXPECT_EQ(errorOf([&] { files.read("/dev/null/a.obj", "f", repairs); }),
              "MESH FILE [/dev/null/a.obj] cannot read \"f\": not a directory");
    const std::string endings = "the name of a mesh file ends in .obj, .ply, .stl, .gltf or .glb";
    EXPECT_EQ(reason("mesh.foo", blockObj()), endings);
    EXPECT_EQ(reason("mesh", blockObj()), endings);
    for (const char* name : {"a.obj", "a.ply", "a.stl", "a.gltf", "a.glb"}) EXPECT_EQ(reason(name, ""), "it is empty");
}

TEST_F(MeshFileTest, ABrokenFileIsToldByItsReader) {
    EXPECT_EQ(reason("a.obj", blockObj() + "f 1 2 9\n"), "line 15: a face names vertex 9 of 8");
    EXPECT_EQ(reason("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "no face has an area");
    EXPECT_EQ(reason("a.ply", blockPly().substr(0, 60)), "its header has no end");
    EXPECT_EQ(reason("a.ply", blockObj()), "it does not begin with a line \"ply\"");
    EXPECT_EQ(reason("a.stl", blockStl().substr(0, 400)), "it has no line \"endsolid\": its end is missing");
    EXPECT_EQ(reason("a.glb", blockGlb().substr(0, 20)), "it has 20 bytes, but its header tells of 628");
    EXPECT_EQ(reason("a.gltf", blockGltf(R"([{"mesh":7}])", "")), "its node 0 names mesh 7 of 1");
}

// What it announces is compared with what it holds before memory is asked for.
TEST_F(MeshFileTest, AFileThatAnnouncesTooMuchIsRefused) {
    const std::string announced = plyHeader("ascii", "1000000000", "6");
    EXPECT_EQ(reason("a.ply", announced + "0 0 0\n"),
              "it announces 1000000000 vertex elements and has room for 1 at the most");
    EXPECT_EQ(reason("a.ply", plyHeader("binary_big_endian", "1", "1000000000") + bytesOf(0, 0, 0)),
              "it announces 1000000000 face elements and has room for 0 at the most");
    EXPECT_EQ(reason("a.stl", blockBinaryStl().substr(0, 80) + bytesOf(1000000000)),
              "it announces 1000000000 triangles, which take 50000000084 bytes, and has 84");
}

TEST_F(MeshFileTest, OtherFilesLieBelowTheirMesh) {
    const auto gltf = [](const std::string& path) { return blockGltf(R"([{"mesh":0}])", ",\"uri\":\"" + path + "\""); };
    folder.write("block.bin", blockBuffer());
    std::filesystem::create_directories(folder / "inner");
    std::filesystem::create_symlink("../block.bin", folder / "inner/link.bin");
    std::filesystem::create_symlink("block.bin", folder / "link.bin");
    const std::string place = folder / "block.bin";
    EXPECT_EQ(read("a.gltf", gltf("link.bin"))->triangleCount(), 12u);
    EXPECT_EQ(read("a.gltf", gltf("./inner/../block.bin"))->triangleCount(), 12u);
    EXPECT_EQ(reason("inner/a.gltf", gltf("../block.bin")),
              "its buffer 0 is at \"../block.bin\", which is not below the file's own folder");
    EXPECT_EQ(reason("inner/a.gltf", gltf(place)),
              "its buffer 0 is at \"" + place + "\", which is not below the file's own folder");
    EXPECT_EQ(reason("inner/a.gltf", gltf("link.bin")),
              "its buffer 0: the file \"link.bin\" leads out of the mesh's own folder");
    EXPECT_EQ(reason("a.gltf", gltf("none.bin")),
              "its buffer 0: the file \"none.bin\" cannot be read: no such file or directory");
}

TEST_F(MeshFileTest, AFileWhoseBufferHasChangedIsReadAgain) {
    folder.write("block.bin", blockBuffer());
    const std::string gltf = blockGltf(R"([{"mesh":0}])", R"(,"uri":"block.bin")");
    const auto first = read("a.gltf", gltf);
    EXPECT_EQ(files.read(folder / "a.gltf", "a.gltf", repairs), first);
    std::string doubled = blockBuffer();
    const float two = 2;
    for (const std::size_t x : {12, 24, 60, 72}) doubled.replace(x, sizeof two, bytesOf(two));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    folder.write("block.bin", doubled);
    const auto second = files.read(folder / "a.gltf", "a.gltf", repairs);
    EXPECT_EQ(first->bounds().high.x, 1);
    EXPECT_EQ(second->bounds().high.x, 2);
}

TEST_F(MeshFileTest, KeepsWhatTheFileKnows) {
    // The second face is turned, the third one dropped: what they have goes with them.
    const auto mesh = read("a.obj",
                           "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                           "o left\nusemtl red\nf 1/1 2/2 3/3\no none\nf 1 1 2\no right\nusemtl blue\nf 3/3 1/1 4/4\n"
                           "f 5/1 7/2 6/3\nv 0 0 9\nv 1 0 9\nv 0 1 9\n");
    ASSERT_EQ(mesh->triangleCount(), 3u);
    EXPECT_EQ(mesh->groups().size(), 3u);
    EXPECT_EQ(mesh->groups()[0], (MeshGroup{"left", "red"}));
    EXPECT_EQ(mesh->groups()[2], (MeshGroup{"right", "blue"}));
    const std::map<std::pair<float, float>, core::Vec2f> uvAt{
        {{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}, {{1, 1}, {1, 1}}, {{0, 1}, {0, 1}}};
    for (std::uint32_t i = 0; i < 3; ++i) {
        const bool isFar = mesh->vertex(i, 0).z == 9;
        for (int k = 0; k < 3 && !isFar; ++k) {
            const core::Vec3f v = mesh->vertex(i, k);
            EXPECT_EQ(mesh->uvs()[3 * i + static_cast<unsigned>(k)], uvAt.at({v.x, v.y}));
            const core::Rgbf colour = v.y == 0 ? core::Rgbf(v.x == 0, v.x == 1, 0) : core::Rgbf(v.x == 0, v.x == 0, 1);
            EXPECT_EQ(mesh->colours()[3 * i + static_cast<unsigned>(k)], colour);
        }
        const bool isLeft = !isFar && mesh->vertex(i, 0).y + mesh->vertex(i, 1).y + mesh->vertex(i, 2).y == 1;
        EXPECT_EQ(mesh->groupOf()[i], isLeft ? 0u : 2u);
    }
}

}  // namespace
}  // namespace gr
