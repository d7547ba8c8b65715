// A mesh of which no two vertices are at one place.
#pragma once

#include "gr/mesh/import/source_mesh.h"

namespace gr::importer {

// Vertices are relative to an origin, so that a mesh that lies far away keeps its shape. Those that no face has are
// left out, and those that are the same in single precision are one.
struct JoinedMesh {
    glm::dvec3 origin{0};
    std::vector<core::Vec3f> vertices;
    SourceMesh
        source;  // its corners name `vertices`; its own vertices are gone, and its lists are as long as its corners
};

// Throws Failure for a mesh without faces and for coordinates that are not finite, or too large.
JoinedMesh join(SourceMesh&& mesh);

}  // namespace gr::importer
