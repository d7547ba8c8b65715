// The steps from polygons as they come to triangles that can be rendered. Each counts what it mends.
#pragma once

#include "gr/mesh/polyhedron.h"

namespace gr {

// Lets vertices at the very same place be one.
void mergeVertices(FlatMesh& mesh, MeshRepairs& repairs);

// Drops vertices that a face repeats or goes to and straight back from, then faces without area.
void dropDegenerate(FlatMesh& mesh, MeshRepairs& repairs);

// Winds all faces that hang together alike; where they close a body, outwards.
void orientFaces(FlatMesh& mesh, MeshRepairs& repairs);

// What becomes of a face whose outline crosses itself.
enum class Crossing { isAnError, isDropped };

// Cuts every face into triangles that cover it, concave ones too. A triangle is three places in mesh.corners.
std::vector<glm::ivec3> triangulate(const FlatMesh& mesh, Crossing crossing, MeshRepairs& repairs);

// Twice the face's area, along its normal (Newell's method): right for any simple outline, flat or not.
inline glm::dvec3 faceNormal(const std::vector<glm::dvec3>& vertices, std::span<const int> face) {
    // About the first vertex, so that a small face far from the origin keeps its digits.
    const glm::dvec3 origin = vertices[face[0]];
    glm::dvec3 normal(0);
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        normal += glm::cross(vertices[face[i]] - origin, vertices[face[i + 1]] - origin);
    return normal;
}

}  // namespace gr
