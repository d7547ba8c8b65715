// What the readers of OBJ, PLY and STL files make of their bytes; messages are compared word for word.
#include "gr/mesh/import/joined_mesh.h"
#include "gr/mesh/import/obj_file.h"
#include "gr/mesh/import/readers.h"
#include "gr/mesh_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gr::importer {
namespace {

// Six times the volume that the faces enclose, if they face outwards, cut as fans.
double sixVolumes(const SourceMesh& mesh) {
    double sum = 0;
    for (int f = 0, begin = 0; f < mesh.faceCount(); ++f) {
        const int end = mesh.ends.empty() ? begin + 3 : mesh.ends[static_cast<std::size_t>(f)];
        const auto at = [&](int i) {
            return mesh.vertices[static_cast<std::size_t>(mesh.corners[static_cast<std::size_t>(i)])];
        };
        for (int i = begin + 1; i + 1 < end; ++i) sum += glm::dot(at(begin), glm::cross(at(i), at(i + 1)));
        begin = end;
    }
    return sum;
}

std::string reasonOf(auto&& read) {
    try {
        read();
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "no error";
}
std::string objReason(const std::string& text) {
    return reasonOf([&] { join(readObj(text)); });
}
std::string plyReason(const std::string& text) {
    return reasonOf([&] { join(readPly(text)); });
}
std::string stlReason(const std::string& text) {
    return reasonOf([&] { join(readStl(text)); });
}

// A tetrahedron of volume 1/6.
const std::string places = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n", faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

TEST(ObjReader, TakesTheSameTetrahedronInAllTheWaysOfWritingIt) {
    for (const std::string& text : std::initializer_list<std::string>{
             places + faces,
             faces + places,
             "\xEF\xBB\xBF" + places + faces,
             "  v 0 0 0\n\tv 1 0 0\n v 0 1 0\nv 0 0 1\n  f 1 3 2\n\tf 1 2 4\nf 2 3 4\n f 3 1 4\n",
             std::string("v 0. .0 -.0\nv +1 0e9 0\nv 0 1.e0 0\nv 0 0 10e-1\n") + faces,
             places + "f 1 3 2 # bottom\nf 1 2 4\nf 2 3 4 #\nf 3 1 4",
             "v 0 0 0 # 1\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + faces,
             "# C:\\models\\\n" + places + "lod 3\ns 1\nvp 0 1\n" + faces,
             places + "f 1 \\\n3 \\\n2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
             "v 0 0 0 0.2 0.3\nv 1 0 0 1\nv 0 1 0 0.2 0.3\nv 0 0 1 0.2 0.3\n" + faces,
             "v 0 0 0\rv 1 0 0\rv 0 1 0\rv 0 0 1\rf 1 3 2\rf 1 2 4\rf 2 3 4\rf 3 1 4\r",
             "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nv 0 0 1\r\nf 1 3 2\r\nf 1 2 4\r\nf 2 3 4\r\nfo 3 1 4\r\n",
             places + "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n",
             places + "vt 0.5\nvt 0.5 0.5 0 1\nf 1/1 3/1/ 2/2\nf 1// 2 4\nf 2 3 4\nf 3 1 4\n",
         }) {
        SCOPED_TRACE(text);
        const SourceMesh mesh = readObj(text);
        EXPECT_EQ(mesh.faceCount(), 4);
        EXPECT_EQ(mesh.vertices.size(), 4u);
        EXPECT_EQ(sixVolumes(mesh), 1);
        EXPECT_EQ(mesh.linesAndPoints, 0u);
    }
}

TEST(ObjReader, KeepsWhatCornersHave) {
    const SourceMesh mesh = readObj(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.25 0.5\nvt 1 0.75\nvn 0 0 2\nvn 0 3 0\n"
        "f 1 2 3\nf 1/1/1 3//2 4/2\n");
    EXPECT_EQ(mesh.normals, (std::vector{noNormal, noNormal, noNormal, packNormal({0, 0, 1}), packNormal({0, 1, 0})}));
    EXPECT_EQ(mesh.uvs, (std::vector<core::Vec2f>{{0, 0}, {0, 0}, {0, 0}, {0.25f, 0.5f}, {0, 0}, {1, 0.75f}}));
    EXPECT_TRUE(mesh.colours.empty());
    const JoinedMesh joined = join(SourceMesh(mesh));
    EXPECT_EQ(joined.source.normals.size(), 6u);
    EXPECT_EQ(joined.source.normals.back(), noNormal);
}

TEST(ObjReader, ColoursAreLinear) {
    const SourceMesh mesh = readObj("v 0 0 0 0 1 0.5\nv 1 0 0\nv 0 1 0 0.04045 2 -1 0.3\nf 1 2 3\n");
    ASSERT_EQ(mesh.colours.size(), 3u);
    EXPECT_NEAR(mesh.colours[0].b, 0.21404f, 1e-5);
    EXPECT_EQ(mesh.colours[0].g, 1);
    EXPECT_EQ(mesh.colours[1], core::Rgbf(1));
    EXPECT_NEAR(mesh.colours[2].r, 0.04045f / 12.92f, 1e-7);
    EXPECT_EQ(mesh.colours[2].g, 1);
    EXPECT_EQ(mesh.colours[2].b, 0);
}

TEST(ObjReader, NamesGroupsWithTheirMaterials) {
    const SourceMesh mesh =
        readObj(places + "f 1 2 3\no a  house\nusemtl red wall\nf 1 2 3\nf 2 3 4\ng roof\nf 1 2 4\ng\nf 1 2 4\n");
    const auto is = [&](std::size_t i, const std::string& name, const std::string& material, int first) {
        const SourceGroup& group = mesh.groups.at(i);
        return group.name == name && group.material == material && group.firstFace == first;
    };
    ASSERT_EQ(mesh.groups.size(), 3u);
    EXPECT_TRUE(is(0, "", "", 0));
    EXPECT_TRUE(is(1, "a house", "red wall", 1));
    EXPECT_TRUE(is(2, "roof", "red wall", 3));
}

TEST(ObjReader, CountsWhatIsNotThere) {
    const SourceMesh mesh =
        readObj(places + "vn 0 0 1\nf 1//1 2//7 3//1\nf 1/2/1 2//0 3//-2\nvn 0 1 0\nf 1//2 2//2 3//2");
    EXPECT_EQ(mesh.absentReferences, 4u);
    EXPECT_EQ(std::count(mesh.normals.begin(), mesh.normals.end(), noNormal), 3);
    EXPECT_EQ(mesh.normals[8], packNormal({0, 1, 0}));
    EXPECT_EQ(readObj(places + "l 1 2\np 1\nf 1 2\nf 1 2 3\ncurv 0 1 1 2\n").linesAndPoints, 4u);
}

TEST(ObjReader, TellsWhatIsWrongAndWhere) {
    for (const auto& [text, reason] : std::initializer_list<std::pair<std::string, std::string>>{
             {"", "it has no faces"},
             {"# nothing\n", "it has no faces"},
             {places, "it has no faces"},
             {places + "f 1 2 9\n", "line 5: a face names vertex 9 of 4"},
             {places + "f 1 2 5\nf 1 2 9\nv 0 0 0\n", "line 6: a face names vertex 9 of 5"},
             {places + "\n\\\n\\\nf 1 1 0", "line 6: a face names vertex 0 of 4"},
             {places + "f 1 2 -5\n", "line 5: a face names vertex -5 of 4"},
             {places + "f 1 2 99999999999999999999\n", "line 5: a face names vertex 99999999999999999999 of 4"},
             {places + "f 1 2 1.5\n", "line 5: \"1.5\" is not a corner: it must be v, v/vt, v//vn or v/vt/vn"},
             {places + "f 1 2 1/1/1/1\n", "line 5: \"1/1/1/1\" is not a corner: it must be v, v/vt, v//vn or v/vt/vn"},
             {places + "f 1 2 x\n", "line 5: \"x\" is not a corner: it must be v, v/vt, v//vn or v/vt/vn"},
             {"v 0 0 0\nv 1 0,5 0\n", "line 2: \"0,5\" is not a number"},
             {"v 0 0 nan\n", "line 1: \"nan\" is not a number from -1e+18 to 1e+18"},
             {"v 0 1e99 0\n", "line 1: \"1e99\" is not a number from -1e+18 to 1e+18"},
             {"v -1e400 0 0\n", "line 1: \"-1e400\" is not a number from -1e+18 to 1e+18"},
             {"v 0 0\nv 1 1 1\n", "line 1: 3 numbers are needed, not 2"},
             {"v 0 0", "its last line is cut off"},
             {places + "f 1 2", "its last line is cut off"},
             {"v 0 0 0\n\x01\x02z 1", "line 2: \"??z\" is nothing that an OBJ file has"},
             {std::string("v\0 \0", 4) + places, "its text is in UTF-16; it must be in UTF-8"},
             {"\xFF\xFEv", "its text is in UTF-16; it must be in UTF-8"},
         })
        EXPECT_EQ(objReason(text), reason) << text;
}

TEST(ObjReader, ACarriageReturnAloneTakesNoSquareOfTime) {
    std::string text;
    for (int i = 0; i < 300000; ++i) text += "v 0 0 0\r";
    EXPECT_EQ(readObj(text + "f 1 2 3").vertices.size(), 300000u);
}

std::string tetrahedronPly(const std::string& beforeVertices, const std::string& properties,
                           const std::string& betweenElements, const std::string& body) {
    return "ply\nformat ascii 1.0\n" + beforeVertices + "element vertex 4\nproperty float x\nproperty float y\n" +
           "property float z\n" + properties + betweenElements +
           "element face 4\nproperty list uchar int vertex_indices\nend_header\n" + body;
}
const std::string plyPlaces = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", plyFaces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

TEST(PlyReader, TakesTheSameTetrahedronInAllTheWaysOfWritingIt) {
    const std::string camera = "element camera 2\nproperty list uchar float a\nproperty int b\n";
    std::string facesFirst = tetrahedronPly("", "", "", plyFaces + plyPlaces);
    const std::size_t vertices = facesFirst.find("element vertex"), element = facesFirst.find("element face");
    facesFirst = facesFirst.substr(0, vertices) + facesFirst.substr(element, facesFirst.find("end_header") - element) +
                 facesFirst.substr(vertices, element - vertices) + facesFirst.substr(facesFirst.find("end_header"));
    for (const std::string& text : std::initializer_list<std::string>{
             tetrahedronPly("", "", "", plyPlaces + plyFaces),
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
        EXPECT_EQ(plyReason(text), reason) << text;
}

std::string facetStl() {
    return "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
}

TEST(StlReader, TakesTextInAllTheWaysOfWritingIt) {
    std::string capitals = "solid x\n" + facetStl() + "endsolid x\n";
    std::transform(capitals.begin(), capitals.end(), capitals.begin(), [](unsigned char c) { return std::toupper(c); });
    for (const std::string& text : std::initializer_list<std::string>{
             "solid x\n" + facetStl() + "endsolid x\n", capitals, "solid x\n" + facetStl() + "ENDSOLID",
             "solid x\n" + facetStl() + "end solid x\n", "\n \nsolid\n" + facetStl() + "endsolid",
             "\xEF\xBB\xBFsolid x y\n" + facetStl() + "endsolid x y\n",
             "solid a\nendsolid a\nsolid x\n" + facetStl() + "endsolid"}) {
        SCOPED_TRACE(text);
        const SourceMesh mesh = readStl(text);
        ASSERT_EQ(mesh.corners, (std::vector{0, 1, 2}));
        EXPECT_EQ(mesh.vertices[1], glm::dvec3(1, 0, 0));
    }
    const SourceMesh two = readStl("solid a b\n" + facetStl() + "endsolid\nsolid c\n" + facetStl() + "endsolid");
    ASSERT_EQ(two.groups.size(), 2u);
    EXPECT_EQ(two.groups[0].name, "a b");
    EXPECT_EQ(two.groups[1].firstFace, 1);
}

TEST(StlReader, TakesBytes) {
    for (const std::string& tail : std::initializer_list<std::string>{"", "\n", "ab"}) {
        for (const char* head : {" ", "solid "}) {
            std::string bytes = blockBinaryStl() + tail;
            bytes.replace(0, std::strlen(head), head);
            EXPECT_EQ(readStl(bytes).faceCount(), 12);
            EXPECT_EQ(sixVolumes(readStl(bytes)), 36);
        }
    }
}

TEST(StlReader, TellsWhatIsWrong) {
    const std::string good = blockBinaryStl();
    for (const auto& [text, reason] : std::initializer_list<std::pair<std::string, std::string>>{
             {good.substr(0, 80) + bytesOf(1000000000) + good.substr(84),
              "it announces 1000000000 triangles, which take 50000000084 bytes, and has 684"},
             {good.substr(0, 84), "it announces 12 triangles, which take 684 bytes, and has 84"},
             {good.substr(0, 80) + bytesOf(4) + good.substr(84),
              "it announces 4 triangles, which take 284 bytes, and has 684"},
             {good.substr(0, 80) + bytesOf(0), "it has no faces"},
             {"abc", "it is shorter than the header of an STL file"},
             {"solid x\n" + facetStl(), "it has no line \"endsolid\": its end is missing"},
             {"solid x\n" + facetStl().substr(0, 40), "it has no line \"endsolid\": its end is missing"},
             {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
              "line 6: a facet needs 3 vertices at least, not 2"},
             {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 O\n", "line 4: \"O\" is not a number"},
             {"solid x\nfacet\nouter loop\nvertex 0 0 0\nvortex 0 0 0\n",
              "line 5: \"vortex\" stands where vertex or endloop must be"},
             {"solid x\n" + facetStl() + "facets\n",
              "line 9: \"facets\" stands where solid, facet or endsolid must be"},
         })
        EXPECT_EQ(stlReason(text), reason) << text;
}

TEST(JoinedMesh, KeepsTheShapeOfWhatLiesFarAway) {
    SourceMesh mesh =
        readObj("v 5000000 0 9000000\nv 5000000.25 0 9000000\nv 5000000 0.25 9000000.125\nv 9 9 9\nf 1 2 3\n");
    const JoinedMesh joined = join(std::move(mesh));
    ASSERT_EQ(joined.vertices.size(), 3u);
    EXPECT_EQ(joined.origin + glm::dvec3(joined.vertices[1]), glm::dvec3(5000000.25, 0, 9000000));
    EXPECT_EQ(joined.vertices[1] - joined.vertices[0], core::Vec3f(0.25f, 0, 0));
}

TEST(JoinedMesh, WhatNoFaceHasMayBeAnywhere) {
    EXPECT_EQ(join(readPly(tetrahedronPly("", "", "",
                                          "0 0 0\n1 0 0\n0 1 0\nnan inf 1e300\n3 0 2 1\n3 0 1 2\n3 1 2 0\n3 2 0 1\n")))
                  .vertices.size(),
              3u);
    EXPECT_EQ(plyReason(tetrahedronPly("", "", "", "0 0 0\n1 0 0\n0 1 0\nnan 0 0\n" + plyFaces)),
              "a coordinate is not a number from -1e+18 to 1e+18");
}

}  // namespace
}  // namespace gr::importer
