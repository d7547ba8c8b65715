// A cube as a mesh.
#pragma once

#include "gr/mesh/polyhedron.h"

namespace gr {

// [-1, 1]^3, faces outwards.
inline PolygonMesh cubeMesh() {
    PolygonMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return mesh;
}

}  // namespace gr
