// From the doubles of the scene graph to the floats of the scene: where instances and lamps stand, and how far rounding
// may move their points.
#pragma once

#include "gr/scene.h"

#include <glm/mat4x4.hpp>

namespace gr {

// Sets an instance's place and its error bound. matrix: from its shape's own space to the world. A map that turns is
// kept in the scene.
void placeAt(Instance& instance, const glm::dmat4& matrix, Scene& scene);

// The outward normal of a lamp's square under that map, of unit length.
glm::dvec3 lampNormal(const glm::dmat4& matrix);
// The light of a lamp whose instance was placed so.
AreaLight lampAt(const glm::dmat4& matrix, const core::Rgbf& radiance, const Instance& instance);

}  // namespace gr
