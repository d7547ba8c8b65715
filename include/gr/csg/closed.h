// Whether a mesh is a solid.
#pragma once

#include "gr/mesh/polyhedron.h"

namespace gr {

// How many edges are open: those along which not as many triangles run one way as the other. Without any, a ray leaves
// the mesh as often as it enters it.
std::size_t openEdges(const Polyhedron& mesh);

}  // namespace gr
