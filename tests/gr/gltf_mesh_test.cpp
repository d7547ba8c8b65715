// What glTF's accessors and primitives give.
#include "gr/gltf_text.h"

namespace gr {
namespace {

struct GltfMeshTest : GltfTest {
    // The vertices of a triangle whose positions are of this kind.
    Places places(int component, const std::string& bytes, const std::string& more) {
        GltfText text;
        text.add("VEC3", component, 3, bytes, more);
        text.primitives = R"({"attributes":{"POSITION":0}})";
        return read(text).vertices;
    }
};

template<class T>
std::string nine(T a, T b, T c) {
    return bytesOf(a, b, c, T{}, T{}, T{}, T{}, T{}, T{});
}

TEST_F(GltfMeshTest, NumbersOfEveryKind) {
    const std::string normalised = R"(,"normalized":true)";
    EXPECT_EQ(places(5120, nine<std::int8_t>(-128, 127, 3), "")[0], glm::dvec3(-128, 127, 3));
    EXPECT_EQ(places(5120, nine<std::int8_t>(-128, 127, -127), normalised)[0], glm::dvec3(-1, 1, -1));
    EXPECT_EQ(places(5121, nine<std::uint8_t>(255, 51, 0), "")[0], glm::dvec3(255, 51, 0));
    EXPECT_EQ(places(5121, nine<std::uint8_t>(255, 51, 0), normalised)[0], glm::dvec3(1, 0.2, 0));
    EXPECT_EQ(places(5122, nine<std::int16_t>(-32768, 32767, 3), "")[0], glm::dvec3(-32768, 32767, 3));
    EXPECT_EQ(places(5122, nine<std::int16_t>(-32768, 32767, 0), normalised)[0], glm::dvec3(-1, 1, 0));
    EXPECT_EQ(places(5123, nine<std::uint16_t>(65535, 13107, 1), "")[0], glm::dvec3(65535, 13107, 1));
    EXPECT_EQ(places(5123, nine<std::uint16_t>(65535, 13107, 0), normalised)[0], glm::dvec3(1, 0.2, 0));
    EXPECT_EQ(places(5125, nine<std::uint32_t>(4294967295, 7, 0), "")[0], glm::dvec3(4294967295, 7, 0));
    EXPECT_EQ(places(5126, nine(-0.5f, 1e18f, 3e-30f), normalised)[0], glm::dvec3(-0.5f, 1e18f, 3e-30f));
}

TEST_F(GltfMeshTest, SparseElementsReplaceOthers) {
    GltfText text;
    text.addView(bytesOf(2.f, 3.f, 4.f, 5.f, 6.f, 7.f));
    text.addView(bytesOf(std::uint16_t{2}, std::uint16_t{0}));
    const std::string sparse =
        R"(,"sparse":{"count":2,"indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":0}})";
    text.add("VEC3", 5126, 3, nine(9.f, 9.f, 9.f), sparse);
    text.primitives = R"({"attributes":{"POSITION":0}})";
    EXPECT_EQ(read(text).vertices, (Places{{5, 6, 7}, {0, 0, 0}, {2, 3, 4}}));
    // Without a buffer view all others are 0.
    text.accessors.clear();
    text.accessorCount = 0;
    text.addAccessor("VEC3", 5126, 4, sparse);
    EXPECT_EQ(read(text).vertices, (Places{{5, 6, 7}, {0, 0, 0}, {2, 3, 4}}));
    text.accessors.replace(text.accessors.find("\"count\":4"), 9, "\"count\":2");
    EXPECT_EQ(reason(text), "its accessor 0's sparse names element 2 of 2");
    text.accessors.replace(text.accessors.find("5123"), 4, "5122");
    EXPECT_EQ(reason(text),
              "its accessor 0's sparse's indices has componentType 5122, but an element's number is 5121, "
              "5123 or 5125");
}

TEST_F(GltfMeshTest, InterleavedElementsMayEndWithTheLastOne) {
    const auto interleaved = [](const std::string& stride, int cut) {
        GltfText text;
        std::string bytes;
        for (const float x : {0.f, 1.f, 2.f}) bytes += bytesOf(x, x * x, 0.f, 0.f, 0.f, 1.f);
        text.addView(bytes.substr(0, bytes.size() - static_cast<std::size_t>(cut)), R"(,"byteStride":)" + stride);
        text.addAccessor("VEC3", 5126, 3, R"(,"bufferView":0)");
        text.addAccessor("VEC3", 5126, 3, R"(,"bufferView":0,"byteOffset":12)");
        text.primitives = R"({"attributes":{"POSITION":0,"NORMAL":1}})";
        return text;
    };
    const importer::SourceMesh mesh = read(interleaved("24", 0));
    EXPECT_EQ(mesh.vertices, (Places{{0, 0, 0}, {1, 1, 0}, {2, 4, 0}}));
    EXPECT_EQ(mesh.normals, std::vector(3, packNormal({0, 0, 1})));
    EXPECT_EQ(reason(interleaved("24", 1)),
              "its accessor 1 has more elements than bufferView 0 holds: 3 of 12 bytes "
              "from byte 12 on, one in 24, in 71");
    GltfText positions = interleaved("24", 12);
    positions.primitives = R"({"attributes":{"POSITION":0}})";
    EXPECT_EQ(read(positions).vertices[2], glm::dvec3(2, 4, 0));
    EXPECT_EQ(reason(interleaved("8", 0)), "its accessor 0 has elements of 12 bytes, but bufferView 0 one in 8");
}

TEST_F(GltfMeshTest, AnnouncedCountsAreNotBelieved) {
    GltfText text;
    text.addView(bytesOf(0.f));
    text.primitives = R"({"attributes":{"POSITION":0}})";
    const auto said = [&](const std::string& count, const std::string& more) {
        text.accessors = R"({"type":"VEC3","componentType":5126,"count":)" + count + more + "}";
        return reason(text);
    };
    const std::string view = R"(,"bufferView":0)";
    EXPECT_EQ(
        said("1", view),
        "its accessor 0 has more elements than bufferView 0 holds: 1 of 12 bytes from byte 0 on, one in 12, in 4");
    EXPECT_EQ(said("18446744073709551615", view),
              "its accessor 0 has more elements than bufferView 0 holds: "
              "18446744073709551615 of 12 bytes from byte 0 on, one in 12, in 4");
    EXPECT_EQ(said("1", view + R"(,"byteOffset":18446744073709551615)"),
              "its accessor 0 has more elements than bufferView 0 holds: 1 of 12 bytes from byte 18446744073709551615 "
              "on, one in 12, in 4");
    EXPECT_EQ(said("16777217", ""),
              "its accessor 0 has 16777217 elements without a bufferView, of which 16777216 are read at most");
    EXPECT_EQ(said("0", view), "it has no faces");
    EXPECT_EQ(said("-3", view), "its accessor 0's \"count\" is not a whole number from 0");
    text.views = R"({"buffer":0,"byteOffset":1,"byteLength":18446744073709551615})";
    EXPECT_EQ(said("1", view),
              "its bufferView 0 has 18446744073709551615 bytes from byte 1 on, more than buffer 0 with its 4");
}

TEST_F(GltfMeshTest, TypesAreChecked) {
    GltfText text = triangleText();
    text.accessors = R"({"type":"VEC2","componentType":5126,"count":3,"bufferView":0})";
    EXPECT_EQ(reason(text), "its accessor 0 is VEC2, but POSITION is VEC3");
    text.accessors = R"({"type":"VEC5","componentType":5126,"count":3,"bufferView":0})";
    EXPECT_EQ(reason(text), "its accessor 0's \"type\" is \"VEC5\", which is not one of glTF's");
    text.accessors = R"({"type":"VEC3","componentType":5124,"count":3,"bufferView":0})";
    EXPECT_EQ(reason(text),
              "its accessor 0's \"componentType\" is 5124 instead of 5120, 5121, 5122, 5123, 5125 or 5126");
    text = triangleText();
    text.addFloats("VEC2", 2, {0, 0, 0, 0});
    text.primitives = R"({"attributes":{"POSITION":0,"TEXCOORD_0":1}})";
    EXPECT_EQ(reason(text), "its mesh 0's primitive 0 has 2 of TEXCOORD_0 for 3 of POSITION");
    text.primitives = R"({"attributes":{"POSITION":0},"indices":0})";
    EXPECT_EQ(reason(text), "its accessor 0 is VEC3, but an index is SCALAR");
}

// Five vertices in a row, drawn in some mode.
struct Drawn {
    GltfText text;
    Drawn(int mode, const std::string& indices, int component, std::size_t count) {
        text.addVectors({0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 0, 0, 4, 1, 0});
        if (count > 0) text.add("SCALAR", component, count, indices);
        text.primitives =
            R"({"attributes":{"POSITION":0},"mode":)" + std::to_string(mode) + (count > 0 ? R"(,"indices":1})" : "}");
    }
};

TEST_F(GltfMeshTest, ModesMakeTrianglesThatFaceOneWay) {
    const auto corners = [&](int mode) { return read(Drawn(mode, "", 0, 0).text).corners; };
    EXPECT_EQ(corners(4), (std::vector{0, 1, 2}));  // two are left over
    EXPECT_EQ(corners(5), (std::vector{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    EXPECT_EQ(corners(6), (std::vector{0, 1, 2, 0, 2, 3, 0, 3, 4}));
}

TEST_F(GltfMeshTest, LinesAndPointsAreCounted) {
    for (const auto& [mode, count] : {std::pair(0, 5u), {1, 2u}, {2, 5u}, {3, 4u}}) {
        Drawn drawn(mode, "", 0, 0);
        EXPECT_EQ(reason(drawn.text), "it has no faces");
        drawn.text.primitives += R"(,{"attributes":{"POSITION":0}},{"attributes":{"NORMAL":0}})";
        const importer::SourceMesh mesh = read(drawn.text);
        EXPECT_EQ(mesh.linesAndPoints, count) << mode;
        EXPECT_EQ(mesh.faceCount(), 1) << mode;
    }
}

TEST_F(GltfMeshTest, IndicesOfEveryKind) {
    const std::vector<int> wanted{4, 2, 0, 1, 2, 3};
    EXPECT_EQ(read(Drawn(4, bytesOf('\4', '\2', '\0', '\1', '\2', '\3'), 5121, 6).text).corners, wanted);
    const auto word = [](int i) { return static_cast<std::uint16_t>(i); };
    EXPECT_EQ(read(Drawn(4, bytesOf(word(4), word(2), word(0), word(1), word(2), word(3)), 5123, 6).text).corners,
              wanted);
    EXPECT_EQ(read(Drawn(4, bytesOf(4, 2, 0, 1, 2, 3), 5125, 6).text).corners, wanted);
    EXPECT_EQ(reason(Drawn(4, bytesOf(4, 2, 0), 5126, 3).text),
              "its accessor 1 has componentType 5126, but an index is 5121, 5123 or 5125");
    EXPECT_EQ(reason(Drawn(4, bytesOf(4, 5, 0), 5125, 3).text), "its mesh 0's primitive 0 names vertex 5 of 5");
    EXPECT_EQ(reason(Drawn(4, bytesOf('\4', '\xff', '\0'), 5121, 3).text),
              "its accessor 1 has index 255, which glTF keeps for restarts and allows nowhere");
}

TEST_F(GltfMeshTest, StripsLoseWhatLeadsFromPartToPart) {
    EXPECT_EQ(read(Drawn(5, bytesOf(0, 1, 2, 2, 3, 3, 4, 2), 5125, 8).text).corners, (std::vector{0, 1, 2, 3, 2, 4}));
}

TEST_F(GltfMeshTest, VerticesThatNoTriangleNeedsAreLeftOut) {
    const importer::SourceMesh mesh = read(Drawn(4, bytesOf(4, 1, 3), 5125, 3).text);
    EXPECT_EQ(mesh.vertices, (Places{{1, 0, 0}, {3, 0, 0}, {4, 1, 0}}));
    EXPECT_EQ(mesh.corners, (std::vector{2, 0, 1}));
}

TEST_F(GltfMeshTest, UvsColoursAndNormalsAreOfCorners) {
    GltfText text = triangleText();
    text.addFloats("VEC2", 2, {0, 0, 0.25f, 1, 2, -1});
    text.add("VEC4", 5121, 3, std::string("\xff\x33\0\xff\0\xff\0\xff\0\0\xff\0", 12), R"(,"normalized":true)");
    text.addVectors({0, 0, 2, 0, 0, 0, -1, 0, 0});
    text.add("SCALAR", 5121, 3, std::string("\2\0\1", 3));
    text.primitives = R"({"attributes":{"POSITION":0}},)"
                      R"({"attributes":{"POSITION":0,"TEXCOORD_0":1,"COLOR_0":2,"NORMAL":3},"indices":4},)"
                      R"({"attributes":{"POSITION":0}})";
    const importer::SourceMesh mesh = read(text);
    EXPECT_EQ(mesh.faceCount(), 3);
    EXPECT_EQ(mesh.uvs, (std::vector<core::Vec2f>{{0, 0}, {0, 0}, {0, 0}, {2, 2}, {0, 1}, {0.25f, 0}}));
    const core::Rgbf white(1);
    EXPECT_EQ(mesh.colours, (std::vector<core::Rgbf>{white, white, white, {0, 0, 1}, {1, 0.2f, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.normals,
              (std::vector{noNormal, noNormal, noNormal, packNormal({-1, 0, 0}), packNormal({0, 0, 1}), noNormal}));
}

TEST_F(GltfMeshTest, ColoursAreNormalisedOrFloats) {
    GltfText text = triangleText();
    text.add("VEC3", 5121, 3, std::string(9, '\1'));
    text.primitives = R"({"attributes":{"POSITION":0,"COLOR_0":1}})";
    EXPECT_EQ(reason(text), "its accessor 1 has colours of whole numbers that are not normalised");
    text = triangleText();
    text.addVectors({2, 0.5f, 0, 2, 0.5f, 0, 2, 0.5f, 0});
    text.primitives = R"({"attributes":{"POSITION":0,"COLOR_0":1}})";
    EXPECT_EQ(read(text).colours, std::vector(3, core::Rgbf(2, 0.5f, 0)));
}

TEST_F(GltfMeshTest, GroupsAreNamedByMeshOrNodeAndMaterial) {
    GltfText text = triangleText();
    text.primitives = R"({"attributes":{"POSITION":0},"material":0},{"attributes":{"POSITION":0},"material":1},)"
                      R"({"attributes":{"POSITION":0}})";
    text.keys = R"(,"materials":[{"name":"red"},{}])";
    text.nodes = R"({"mesh":0,"name":"chair"})";
    const auto groups = [&] {
        std::string all;
        for (const importer::SourceGroup& group : read(text).groups)
            all += group.name + "/" + group.material + "/" + std::to_string(group.firstFace) + " ";
        return all;
    };
    EXPECT_EQ(groups(), "chair/red/0 chair/material 1/1 chair//2 ");
    text.meshKeys = R"(,"name":"seat")";
    EXPECT_EQ(groups(), "seat/red/0 seat/material 1/1 seat//2 ");
}

}  // namespace
}  // namespace gr
