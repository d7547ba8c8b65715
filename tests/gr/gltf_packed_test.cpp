// Meshes that other programs' libraries have packed.
#include "gr/gltf_text.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

namespace gr {
namespace {

struct GltfPackedTest : GltfTest {};

// Two triangles that share an edge, 2 wide and 1 high, with 16 bytes a vertex, as packed vertices need multiples of 4.
const std::vector<float> places{0, 0, 0, 9, 2, 0, 0, 9, 2, 1, 0, 9, 0, 1, 0, 9};
const std::vector<std::uint32_t> corners{0, 1, 2, 0, 2, 3};

std::string bytesOfAll(const std::vector<unsigned char>& bytes) {
    return {bytes.begin(), bytes.end()};
}

std::string packedVertices(const void* vertices, std::size_t count, std::size_t stride) {
    std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(count, stride));
    packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), vertices, count, stride));
    return bytesOfAll(packed);
}

std::string packedTriangles() {
    std::vector<unsigned char> packed(meshopt_encodeIndexBufferBound(corners.size(), 4));
    packed.resize(meshopt_encodeIndexBuffer(packed.data(), packed.size(), corners.data(), corners.size()));
    return bytesOfAll(packed);
}

std::string packedSequence() {
    std::vector<unsigned char> packed(meshopt_encodeIndexSequenceBound(corners.size(), 4));
    packed.resize(meshopt_encodeIndexSequence(packed.data(), packed.size(), corners.data(), corners.size()));
    return bytesOfAll(packed);
}

// The view itself has another buffer, which is not there.
int addPacked(GltfText& text, const std::string& packed, const std::string& keys) {
    const std::size_t offset = (text.buffer.size() + 3) / 4 * 4;
    text.buffer.resize(offset);
    text.buffer += packed;
    text.views += std::string(text.viewCount > 0 ? "," : "") +
                  R"({"buffer":1,"byteLength":9,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteOffset":)" +
                  std::to_string(offset) + R"(,"byteLength":)" + std::to_string(packed.size()) + keys + "}}}";
    return text.viewCount++;
}

GltfText meshoptText(const std::string& vertexKeys, const std::string& indexKeys, const std::string& indices) {
    GltfText text;
    addPacked(text, packedVertices(places.data(), 4, 16), R"(,"mode":"ATTRIBUTES",)" + vertexKeys);
    addPacked(text, indices, indexKeys);
    text.addAccessor("VEC3", 5126, 4, R"(,"bufferView":0)");
    text.addAccessor("SCALAR", 5125, 6, R"(,"bufferView":1)");
    text.primitives = R"({"attributes":{"POSITION":0},"indices":1})";
    return text;
}

const std::string vertexKeys = R"("byteStride":16,"count":4)",
                  triangleKeys = R"(,"mode":"TRIANGLES","byteStride":4,"count":6)",
                  sequenceKeys = R"(,"mode":"INDICES","byteStride":4,"count":6)";

TEST_F(GltfPackedTest, MeshoptGivesVerticesAndTriangles) {
    for (const auto& [keys, indices] :
         {std::pair(triangleKeys, packedTriangles()), std::pair(sequenceKeys, packedSequence())}) {
        const importer::SourceMesh mesh = read(meshoptText(vertexKeys, keys, indices));
        EXPECT_EQ(mesh.vertices, (Places{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}));
        EXPECT_EQ(mesh.corners, (std::vector{0, 1, 2, 0, 2, 3}));
    }
}

TEST_F(GltfPackedTest, MeshoptFiltersAreApplied) {
    // 2^E * M, with M in the low 24 bits and E in the high 8.
    const auto number = [](int exponent, int mantissa) {
        return static_cast<std::uint32_t>(exponent) << 24 | (static_cast<std::uint32_t>(mantissa) & 0xffffff);
    };
    const std::vector<std::uint32_t> words{0, 0, 0, number(1, 3), 0, 0, number(-1, 1), number(0, -5), 0};
    GltfText text;
    addPacked(text, packedVertices(words.data(), 3, 12),
              R"(,"mode":"ATTRIBUTES","filter":"EXPONENTIAL","byteStride":12,"count":3)");
    text.addAccessor("VEC3", 5126, 3, R"(,"bufferView":0)");
    // Unit vectors on an octahedron: (0, 0), and (1, 0), where 127 is 1.
    const std::vector<signed char> folded{0, 0, 127, 0, 127, 0, 127, 0, 0, 127, 127, 0};
    addPacked(text, packedVertices(folded.data(), 3, 4),
              R"(,"mode":"ATTRIBUTES","filter":"OCTAHEDRAL","byteStride":4,"count":3)");
    text.addAccessor("VEC3", 5120, 3, R"(,"normalized":true,"bufferView":1)");
    text.primitives = R"({"attributes":{"POSITION":0,"NORMAL":1}})";
    const importer::SourceMesh mesh = read(text);
    EXPECT_EQ(mesh.vertices, (Places{{0, 0, 0}, {6, 0, 0}, {0.5, -5, 0}}));
    EXPECT_EQ(mesh.normals, (std::vector{packNormal({0, 0, 1}), packNormal({1, 0, 0}), packNormal({0, 1, 0})}));
}

TEST_F(GltfPackedTest, BrokenMeshoptIsTold) {
    const std::string triangles = packedTriangles(), place = "its bufferView 0's EXT_meshopt_compression";
    const auto said = [&](const std::string& keys) { return reason(meshoptText(keys, triangleKeys, triangles)); };
    EXPECT_EQ(said(R"("byteStride":16,"count":300)"), place + " is not what meshoptimizer packs");
    EXPECT_EQ(said(R"("byteStride":16,"count":1000000000000)"), place + " is not what meshoptimizer packs");
    EXPECT_EQ(said(R"("byteStride":6,"count":4)"), place + "'s \"byteStride\" is 6, which \"ATTRIBUTES\" cannot have");
    EXPECT_EQ(said(R"("byteStride":16)"), place + " has no \"count\"");
    EXPECT_EQ(said(vertexKeys + R"(,"filter":"OCTAHEDRAL")"),
              place + "'s \"filter\" is \"OCTAHEDRAL\", which does not go with its stride or mode");
    EXPECT_EQ(said(vertexKeys + R"(,"filter":"WAVY")"), place + "'s \"filter\" is \"WAVY\", which is not known");
    EXPECT_EQ(reason(meshoptText(vertexKeys, R"(,"mode":"TRIANGLES","byteStride":4,"count":5)", triangles)),
              "its bufferView 1's EXT_meshopt_compression's \"count\" is 5, which makes no triangles");
    EXPECT_EQ(reason(meshoptText(vertexKeys, R"(,"mode":"LINES","byteStride":4,"count":6)", triangles)),
              "its bufferView 1's EXT_meshopt_compression's \"mode\" is \"LINES\" instead of \"ATTRIBUTES\", "
              "\"TRIANGLES\" or \"INDICES\"");
}

// The two triangles with uvs of one value, 0.25 0.75; attributes get the numbers 0 and 1.
std::string packedDraco() {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    const float value[2] = {0.25f, 0.75f};
    for (unsigned f = 0; f < 2; ++f) {
        const float* corner[3];
        for (unsigned i = 0; i < 3; ++i) corner[i] = &places[4 * corners[3 * f + i]];
        builder.SetAttributeValuesForFace(position, draco::FaceIndex(f), corner[0], corner[1], corner[2]);
        builder.SetAttributeValuesForFace(uv, draco::FaceIndex(f), value, value, value);
    }
    draco::EncoderBuffer buffer;
    draco::Encoder encoder;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*builder.Finalize(), &buffer).ok());
    return {buffer.data(), buffer.size()};
}

GltfText dracoText(const std::string& packed, const std::string& attributes) {
    GltfText text;
    text.addView(packed);
    text.addAccessor("VEC3", 5126, 4, "");
    text.addAccessor("VEC2", 5126, 4, "");
    text.addAccessor("SCALAR", 5125, 6, "");
    text.primitives = R"({"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"mode":5,"extensions":)"
                      R"({"KHR_draco_mesh_compression":{"bufferView":0,"attributes":)" +
                      attributes + "}}}";
    return text;
}

TEST_F(GltfPackedTest, DracoGivesTrianglesAndAttributes) {
    const importer::SourceMesh mesh = read(dracoText(packedDraco(), R"({"POSITION":0,"TEXCOORD_0":1})"));
    ASSERT_EQ(mesh.faceCount(), 2);
    EXPECT_EQ(mesh.vertices.size(), 4u);
    double area = 0;
    for (int face = 0; face < 2; ++face) {
        const Places at = faceOf(mesh, face);
        area += glm::cross(at[1] - at[0], at[2] - at[0]).z / 2;
    }
    EXPECT_EQ(area, 2);
    EXPECT_EQ(mesh.uvs, std::vector(6, core::Vec2f(0.25f, 0.25f)));
}

TEST_F(GltfPackedTest, BrokenDracoIsTold) {
    const std::string packed = packedDraco(), attributes = R"({"POSITION":0,"TEXCOORD_0":1})";
    const std::string start = "its mesh 0's primitive 0 is not whole Draco data: ";
    for (std::size_t size = 0; size < packed.size(); ++size) {
        const std::string said = reason(dracoText(packed.substr(0, size), attributes));
        EXPECT_TRUE(said.starts_with(start)) << size << ": " << said;
    }
    EXPECT_EQ(
        reason(dracoText(packed, R"({"POSITION":7})")),
        "its mesh 0's primitive 0's KHR_draco_mesh_compression names POSITION by 7, which its Draco data has not");
    EXPECT_EQ(reason(dracoText(packed, R"({"POSITION":1})")),
              "its mesh 0's primitive 0's POSITION is VEC2, but POSITION is VEC3");
    // Attributes that Draco has not come from accessors, which must have as many.
    GltfText other = dracoText(packed, R"({"POSITION":0})");
    EXPECT_EQ(read(other).uvs[0], core::Vec2f(0, 1));
}

}  // namespace
}  // namespace gr
