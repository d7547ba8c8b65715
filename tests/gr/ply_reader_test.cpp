// What becomes of PLY files; messages are compared word for word.
#include "gr/mesh_source.h"

#include <algorithm>
#include <bit>

namespace gr::importer {
namespace {

TEST(PlyReader, TakesTheSameTetrahedronInAllTheWaysOfWritingIt) {
    const std::string camera = "element camera 2\nproperty list uchar float a\nproperty int b\n";
    std::string facesFirst = tetrahedronPly("", "", "", plyFaces + plyPlaces);
    const std::size_t vertices = facesFirst.find("element vertex"), element = facesFirst.find("element face");
    facesFirst = facesFirst.substr(0, vertices) + facesFirst.substr(element, facesFirst.find("end_header") - element) +
                 facesFirst.substr(vertices, element - vertices) + facesFirst.substr(facesFirst.find("end_header"));
    for (const std::string& text : std::initializer_list<std::string>{
             tetrahedronPly("", "", "", plyPlaces + plyFaces),
             tetrahedronPly("Created by hand\n", "", "", plyPlaces + plyFaces),
             tetrahedronPly("comment x\n", "comment hi\nobj_info hi\n", "", plyPlaces + "\n\n" + plyFaces),
             tetrahedronPly(camera, "", "", "2 9 9 1\n0 5\n" + plyPlaces + plyFaces),
             tetrahedronPly("", "", camera, plyPlaces + "0 1\n3 1 2 3 1\n" + plyFaces),
             facesFirst,
         }) {
        SCOPED_TRACE(text);
        const SourceMesh mesh = readPly(text);
        EXPECT_EQ(mesh.faceCount(), 4);
        EXPECT_EQ(mesh.vertices.size(), 4u);
        EXPECT_EQ(sixVolumes(mesh), 1);
    }
}

std::string reversed(std::string bytes) {
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

TEST(PlyReader, ReadsBytesOfEitherOrderBehindEachEndOfALine) {
    for (const std::string& end : std::initializer_list<std::string>{"\n", "\r\n", "\r"}) {
        for (const bool isBig : {false, true}) {
            std::string header = plyHeader(isBig ? "binary_big_endian" : "binary_little_endian", "3", "1");
            for (std::size_t at = 0; (at = header.find('\n', at)) != header.npos; at += end.size())
                header.replace(at, 1, end);
            // The first number begins with the byte of a line's end.
            std::string body;
            const float first = std::bit_cast<float>(isBig ? 0x0A0D4020u : 0x40200D0Au);
            for (const float number : {first, 1.f, 2.f, 3.f, 4.f, 5.f, 6.f, 7.f, 9.f})
                body += isBig ? reversed(bytesOf(number)) : bytesOf(number);
            body += '\3';
            for (const int number : {2, 0, 1}) body += isBig ? reversed(bytesOf(number)) : bytesOf(number);
            const SourceMesh mesh = readPly(header + body);
            EXPECT_EQ(mesh.vertices[0], glm::dvec3(first, 1, 2));
            EXPECT_EQ(mesh.vertices[2], glm::dvec3(6, 7, 9));
            EXPECT_EQ(mesh.corners, (std::vector{2, 0, 1}));
        }
    }
}

TEST(PlyReader, TakesEachTypeOfNumber) {
    std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n", body;
    for (const char* name :
         {"char a", "uchar b", "short c", "ushort d", "int e", "uint f", "float32 g", "double x", "int8 y", "uint16 z"})
        header += std::string("property ") + name + "\n";
    header += "element face 1\nproperty list uint short vertex_index\nend_header\n";
    for (int i = 0; i < 3; ++i)
        body += bytesOf(char{1}, char{2}, short{3}, short{4}, 5, 6, 7.f) + bytesOf(0.1 + i, char(-i)) +
                bytesOf(static_cast<unsigned short>(65535 - i));
    body += bytesOf(3, short{2}, short{1}, short{0});
    const SourceMesh mesh = readPly(header + body);
    EXPECT_EQ(mesh.vertices[2], glm::dvec3(0.1 + 2, -2, 65533));
    EXPECT_EQ(mesh.corners, (std::vector{2, 1, 0}));
}

TEST(PlyReader, CutsStripsIntoTriangles) {
    const SourceMesh mesh = readPly(
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
        "property float z\nelement tristrips 2\nproperty list int int vertex_indices\n"
        "end_header\n0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n9 0 1 2 3 -1 2 3 4 5\n"
        "5 0 1 2 2 3\n");
    EXPECT_EQ(mesh.corners, (std::vector{0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5, 0, 1, 2}));
}

TEST(PlyReader, KeepsWhatVerticesHave) {
    const SourceMesh mesh =
        readPly(tetrahedronPly("",
                               "property float nx\nproperty float ny\nproperty float nz\nproperty float s\n"
                               "property float t\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n",
                               "",
                               "0 0 0 0 0 2 0.5 0.25 255 0 128\n1 0 0 0 0 0 1 1 0 0 0\n0 1 0 0 1 0 0 0 0 0 0\n"
                               "0 0 1 1 0 0 0 0 0 0 0\n" +
                                   plyFaces));
    EXPECT_EQ(mesh.normals[0], packNormal({0, 0, 1}));
    EXPECT_EQ(mesh.normals[1], packNormal({0, 1, 0}));
    EXPECT_EQ(mesh.normals[2], noNormal);
    EXPECT_EQ(mesh.uvs[0], core::Vec2f(0.5f, 0.25f));
    EXPECT_EQ(mesh.colours[0].r, 1);
    EXPECT_EQ(mesh.colours[0].g, 0);
    EXPECT_NEAR(mesh.colours[0].b, 0.215861f, 1e-6);
}

TEST(PlyReader, KeepsUvOfFaces) {
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
        "end_header\n0 0 0\n1 0 0\n0 1 0\n";
    const SourceMesh mesh = readPly(header + "3 0 1 2 0\n3 2 1 0 6 0 1 2 3 4 5\n");
    EXPECT_EQ(mesh.uvs, (std::vector<core::Vec2f>{{0, 0}, {0, 0}, {0, 0}, {0, 1}, {2, 3}, {4, 5}}));
}

TEST(PlyReader, TellsWhatIsWrong) {
    const std::string good = tetrahedronPly("", "", "", plyPlaces + plyFaces);
    for (const auto& [text, reason] : std::initializer_list<std::pair<std::string, std::string>>{
             {tetrahedronPly("", "", "", plyPlaces + "3 0 2 1\n3 0 1 4\n3 1 2 3\n3 2 0 3\n"),
              "a face names vertex 4 of 4"},
             {tetrahedronPly("", "", "", plyPlaces + "3 0 2 1\n3 0 1 0.5\n3 1 2 3\n3 2 0 3\n"),
              "a face names a vertex by what is no whole number"},
             {tetrahedronPly("", "", "", plyPlaces + "3 0 2 1\n3 0 1\n3 1 2 3\n3 2 0 3\n"),
              "line 15: it ends before the property vertex_indices"},
             {tetrahedronPly("", "", "", plyPlaces + "3 0 2 1\n3 0 1 3 7\n3 1 2 3\n3 2 0 3\n"),
              "line 15: \"7\" is more than the header announces"},
             {tetrahedronPly("", "", "", "0 0 0\n1 x 0\n0 1 0\n0 0 1\n" + plyFaces), "line 11: \"x\" is not a number"},
             {tetrahedronPly("", "", "", plyPlaces + "-1 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"),
              "a list of its face elements has no length that can be"},
             {good.substr(0, good.size() - 8), "it announces 4 face elements and ends after 3"},
             {tetrahedronPly("", "property vector w\n", "", ""), "its header has no such type as \"vector\""},
             {tetrahedronPly("", "properti float w\n", "", ""), "its header has no such keyword as \"properti\""},
             {"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",
              "its vertices have no x, y and z"},
             {"ply\nformat ascii 1.0\nelement face 1\nproperty int n\nend_header\n0\n",
              "its face elements have no list vertex_indices"},
             {"ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float "
              "z\nend_header\n",
              "it has no faces"},
             {std::string("\0p\0l\0y", 6), "its text is in UTF-16; it must be in UTF-8"},
         })
        EXPECT_EQ(reasonOf(readPly, text), reason) << text;
}

}  // namespace
}  // namespace gr::importer
