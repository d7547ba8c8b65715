// A round mesh with corners of both kinds.
#pragma once

#include "gr/mesh/polyhedron.h"

#include <cmath>

namespace gr {

// Radius 1, round the origin: rings of four-sided faces, and triangles round the poles. Cut into triangles it has
// 2 * sides * (rings - 1) of them.
inline PolygonMesh uvSphereMesh(int rings, int sides) {
    PolygonMesh mesh;
    for (int ring = 1; ring < rings; ++ring)
        for (int side = 0; side < sides; ++side) {
            const double theta = M_PI * ring / rings, phi = 2 * M_PI * side / sides;
            mesh.vertices.push_back(
                {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)});
        }
    const int north = sides * (rings - 1), south = north + 1;
    mesh.vertices.push_back({0, 1, 0});
    mesh.vertices.push_back({0, -1, 0});
    for (int side = 0; side < sides; ++side) {
        const int next = (side + 1) % sides, last = (rings - 2) * sides;
        mesh.faces.push_back({north, next, side});
        mesh.faces.push_back({south, last + side, last + next});
        for (int ring = 0; ring + 2 < rings; ++ring)
            mesh.faces.push_back(
                {ring * sides + side, ring * sides + next, (ring + 1) * sides + next, (ring + 1) * sides + side});
    }
    return mesh;
}

}  // namespace gr
