// What becomes of OBJ files; messages are compared word for word.
#include "gr/mesh_source.h"

#include <algorithm>

namespace gr::importer {
namespace {

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
        EXPECT_EQ(reasonOf(readObj, text), reason) << text;
}

TEST(ObjReader, ACarriageReturnAloneTakesNoSquareOfTime) {
    std::string text;
    for (int i = 0; i < 300000; ++i) text += "v 0 0 0\r";
    EXPECT_EQ(readObj(text + "f 1 2 3").vertices.size(), 300000u);
}

}  // namespace
}  // namespace gr::importer
