// Which closed parts of a mesh lie in which others.
#pragma once

#include "gr/mesh/polyhedron.h"

namespace gr {

// A part of a mesh whose faces hang together and have no edge that is one face's only.
struct Solid {
    std::span<const int> faces;  // numbers in the mesh
    double volume;  // in any unit, at least 0
};

// For each solid the smallest of those that it lies in, or -1. They should not cross each other: of one that does, most
// of three of its vertices decide. However a solid's faces are wound is the same.
//
// Of n solids each is looked up among the boxes round the others, in log n where boxes overlap little. Only where one
// box holds another, the faces of the larger one are put in a tree, in f log f for f of them, and three rays are shot
// from the smaller one: each takes log f and as much as there are faces on its way. Of n solids that all hold each
// other n^2 / 2 pairs are looked at.
std::vector<int> enclosing(const FlatMesh& mesh, std::span<const Solid> solids);

}  // namespace gr
