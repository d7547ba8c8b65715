// Meshes from files, good ones and broken ones. Messages are compared word for word.
#include "gr/accelerators/accelerator.h"
#include "gr/error_of.h"
#include "gr/mesh/mesh_import.h"
#include "gr/mesh/polyhedron_surface.h"
#include "gr/mesh_text.h"
#include "gr/scene.h"
#include "support/test_random.h"

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
    const FlatMesh mesh = importMesh(folder.write("a.obj", text), repairs);
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

TEST_F(MeshFileTest, BrokenObj) {
    EXPECT_EQ(reason("a.obj", blockObj() + "f 1 2 9\n"), "OBJ: vertex index out of range");
    EXPECT_EQ(reason("a.obj", blockObj() + "f 0 1 2\n"), "OBJ: Invalid face index");
    EXPECT_EQ(reason("a.obj", "# nothing at all here\n"), "it has no faces");
    EXPECT_EQ(reason("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n"), "it has no faces");
    EXPECT_EQ(reason("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "no face has an area");
    EXPECT_EQ(reason("a.obj", blockObj().substr(0, blockObj().size() - 5)), "its last line is cut off");
    for (const char* number : {"nan", "1e19", "-1e300"})
        EXPECT_EQ(reason("a.obj", "v 0 0 " + std::string(number) + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                  "a coordinate is not a number from -1e+18 to 1e+18");
}

TEST_F(MeshFileTest, BrokenPly) {
    const std::string good = blockBinaryPly(), announced = plyHeader("ascii", "1000000000", "6");
    EXPECT_EQ(reason("a.ply", announced + "0 0 0\n"), "it announces 1000000000 vertex elements and ends after 1");
    EXPECT_EQ(reason("a.ply", plyHeader("binary_big_endian", "1", "1000000000") + bytesOf(0, 0, 0)),
              "it announces 1000000000 face elements and ends after 0");
    EXPECT_EQ(reason("a.ply", good.substr(0, good.size() - 1)), "it announces 6 face elements and ends after 5");
    EXPECT_EQ(reason("a.ply", good.substr(0, good.size() - 4) + bytesOf(77)), "a face names vertex 77 of 8");
    EXPECT_EQ(reason("a.ply", good.substr(0, good.size() - 4) + bytesOf(-5)), "a face names vertex -5 of 8");
    EXPECT_EQ(reason("a.ply", blockObj()), "it does not begin with a line \"ply\"");
    EXPECT_EQ(reason("a.ply", good.substr(0, 60)), "its header has no end");
    EXPECT_EQ(reason("a.ply", plyHeader("utf8", "8", "6")),
              "its format is \"utf8\", not ascii, binary_little_endian or binary_big_endian");
    EXPECT_EQ(reason("a.ply", plyHeader("ascii", "-8", "6")),
              "its number of vertex elements is \"-8\", not a whole number");
}

TEST_F(MeshFileTest, BrokenStl) {
    const std::string good = blockBinaryStl();
    EXPECT_EQ(reason("a.stl", good.substr(0, 80) + bytesOf(1000000000) + good.substr(84)),
              "it announces 1000000000 triangles, which take 50000000084 bytes, and has 684");
    EXPECT_EQ(reason("a.stl", good.substr(0, 84)), "it announces 12 triangles, which take 684 bytes, and has 84");
    EXPECT_EQ(reason("a.stl", good.substr(0, 80) + bytesOf(0)), "it has no faces");
    EXPECT_EQ(reason("a.stl", "abc"), "it is shorter than the header of an STL file");
    EXPECT_EQ(reason("a.stl", blockStl().substr(0, 400)), "it has no line \"endsolid\": its end is missing");
}

TEST_F(MeshFileTest, BrokenGltf) {
    const std::string mesh = R"([{"mesh":0}])", uri = R"(,"uri":"block.bin")";
    EXPECT_EQ(reason("a.gltf", blockGltf(mesh, uri)), "GLTF: could not open referenced file \"block.bin\"");
    folder.write("block.bin", blockBuffer());
    EXPECT_EQ(reason("a.gltf", blockGltf(mesh, uri).substr(0, 200)), "it is not a whole .gltf file");
    EXPECT_EQ(reason("a.gltf", blockGltf(mesh, uri, 4)), "a face names a vertex that is not there");
    EXPECT_EQ(reason("a.gltf", blockGltf(mesh, uri, 1000000000)),
              "GLTF: Accessor with offset/length (0/4000000000) is out of range");
    EXPECT_EQ(reason("a.gltf", blockGltf(R"([{"mesh":7}])", uri)),
              R"(GLTF: Array index 7 is out of bounds (1) for "meshes")");
    EXPECT_EQ(reason("a.gltf", blockGltf(R"([{"children":[0]}])", uri)),
              R"(GLTF: Object at index 0 in array "nodes" has recursive reference to itself)");
    EXPECT_EQ(reason("a.gltf", std::string(2000000, '[')), "the importer crashed on it");
    EXPECT_EQ(reason("a.glb", blockGlb().substr(0, blockGlb().size() - 40)), "GLTF: Unable to read gltf file");
}

}  // namespace
}  // namespace gr
