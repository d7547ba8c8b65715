// Meshes of heights over a grid of places.
#pragma once

#include "gr/mesh/polyhedron.h"

namespace gr {

// Heights, row after row.
struct HeightGrid {
    int columns = 0, rows = 0;  // at least 2 each
    std::vector<double> heights;
};

// A mesh over [0,1] x [0,1] in x and z. A row runs along x, from 0 to 1; the first row lies at z = 0, the last at 1: so
// it is seen from above, with -z upwards, as it is written. Each cell is cut along the diagonal that is less steep.
// Normals are those of the differences between the neighbours on both sides, at the border of the parabola through the
// next two; uv are (x, 1 - z). It faces +y.
FlatMesh heightfieldMesh(const HeightGrid& grid);

}  // namespace gr
