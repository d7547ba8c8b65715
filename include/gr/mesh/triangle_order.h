// Puts triangles that are near each other next to each other.
#pragma once

#include "gr/mesh/polyhedron.h"

namespace gr {

// So that each pack of triangles, packWidth of them from the first on, fills a small box. Triangles are given by places
// in mesh.corners.
void sortIntoPacks(const FlatMesh& mesh, std::vector<glm::ivec3>& triangles);

}  // namespace gr
