// Where rays go into an instance's solid and out of it, found from that instance alone, whatever else stands there. The
// work is bounded by the number of its triangles, whatever numbers it is made of.
#pragma once

#include "gr/mesh/mesh_line.h"
#include "gr/scene.h"

#include <vector>

namespace gr {

// Appends the crossings up to ray.tMax, in no order. A ball or a box that the ray goes through from outside to outside
// adds none, nor does what is no solid. A ray that starts or ends on the surface starts or ends outside.
// An endless ray leaves a closed mesh as often as it enters it, and once more for each time that its start is in it,
// also where it runs through edges and vertices.
void addCrossings(const Scene& scene, const Instance& instance, const core::Rayf& ray,
                  std::vector<SolidCrossing>& crossings);

}  // namespace gr
