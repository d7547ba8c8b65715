// What the tests of readers of mesh files share.
#pragma once

#include "gr/mesh/import/joined_mesh.h"
#include "gr/mesh/import/readers.h"
#include "gr/mesh_text.h"

#include <gtest/gtest.h>

namespace gr::importer {

// Six times the volume that the faces enclose, if they face outwards, cut as fans.
inline double sixVolumes(const SourceMesh& mesh) {
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

// Why a reader refuses a file.
inline std::string reasonOf(SourceMesh (*read)(std::string_view), const std::string& file) {
    try {
        join(read(file));
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "no error";
}

// Text of PLY: a tetrahedron's header with something more at three places, and what follows it.
inline std::string tetrahedronPly(const std::string& beforeVertices, const std::string& properties,
                                  const std::string& betweenElements, const std::string& body) {
    return "ply\nformat ascii 1.0\n" + beforeVertices + "element vertex 4\nproperty float x\nproperty float y\n" +
           "property float z\n" + properties + betweenElements +
           "element face 4\nproperty list uchar int vertex_indices\nend_header\n" + body;
}
inline const std::string plyPlaces = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", plyFaces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

}  // namespace gr::importer
