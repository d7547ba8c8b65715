// Normals for shading of a mesh that has none.
#pragma once

#include "gr/mesh/polyhedron.h"

namespace gr {

// Gives each corner the mean normal of the faces round its vertex that are reached from its own over edges which are
// not sharp: shared by just two faces, whose normals differ by less than so many degrees. Each counts by its angle at
// the vertex (Thürmer and Wüthrich, "Computing Vertex Normals from Polygonal Facets", Journal of Graphics Tools 1998),
// so that it does not matter how a flat part is cut into faces. A corner between sharp edges has its face's normal.
//
// To be called when faces are wound alike. Leaves a mesh that has normals as it is, and any if degrees is 0. Of k
// corners at one vertex it takes k log k.
void smoothNormals(FlatMesh& mesh, double degrees);

}  // namespace gr
