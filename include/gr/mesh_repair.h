// The steps from polygons as they come to triangles that can be rendered. Each counts what it mends.
#pragma once

#include "gr/polyhedron.h"

namespace gr {

// Lets vertices at the very same place be one.
void mergeVertices(PolygonMesh& mesh, MeshRepairs& repairs);

// Drops vertices that a face repeats or goes to and straight back from, then faces without area.
void dropDegenerate(PolygonMesh& mesh, MeshRepairs& repairs);

// Winds all faces that hang together alike; where they close a body, outwards.
void orientFaces(PolygonMesh& mesh, MeshRepairs& repairs);

// Cuts every face into triangles that cover it, concave ones too. Throws core::Error for a face whose outline
// crosses itself.
std::vector<glm::ivec3> triangulate(const PolygonMesh& mesh);

// Twice the face's area, along its normal (Newell's method): right for any simple outline, flat or not.
glm::dvec3 faceNormal(const PolygonMesh& mesh, const std::vector<int>& face);

}  // namespace gr
