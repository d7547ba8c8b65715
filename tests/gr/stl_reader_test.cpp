// What becomes of STL files; messages are compared word for word.
#include "gr/mesh_source.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace gr::importer {
namespace {

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
        EXPECT_EQ(reasonOf(readStl, text), reason) << text;
}

}  // namespace
}  // namespace gr::importer
