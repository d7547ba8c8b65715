// Vertices at one place become one, relative to the mesh's middle.
#include "gr/mesh_source.h"

namespace gr::importer {
namespace {

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
    EXPECT_EQ(reasonOf(readPly, tetrahedronPly("", "", "", "0 0 0\n1 0 0\n0 1 0\nnan 0 0\n" + plyFaces)),
              "a coordinate is not a number from -1e+18 to 1e+18");
}

}  // namespace
}  // namespace gr::importer
