// Which objects many rays at once are tested against one after the other, and which are for the accelerator.
#pragma once

#include "gr/scene.h"

#include <vector>

namespace gr {

// Fills the scene's faces, large and bodies. boxes: of all instances.
void sortForManyRays(Scene& scene, const std::vector<core::Bounds>& boxes);

}  // namespace gr
