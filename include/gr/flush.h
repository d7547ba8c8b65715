// What lies flush with something else, a lamp in the plane of a ceiling or a glass block on a floor: which of the two a
// ray meets first would be up to rounding.
#pragma once

#include "gr/contacts.h"

#include <glm/mat4x4.hpp>

namespace gr {

// Transparent objects grow by a hair where a flat side of theirs touches another, or is nearer to it than rounding can
// tell, so that a path meets what is beyond their face while it is inside of them: the floor on which they stand, or
// the block at their side. Of its size no object grows by more than a thousandth. boxes: the instances' bounds, which
// are kept true. Returns by how much each instance has grown.
std::vector<float> growTouching(Scene& scene, std::span<const Contact> contacts, std::vector<core::Bounds>& boxes);

struct Lamp {
    std::uint32_t instance;
    glm::dmat4 matrix;  // from its square's own space to the world
};

// Lamps that touch something are lifted off it, to the side to which they shine. lamps: as the scene's area lights.
// grown: as above.
void liftLamps(Scene& scene, std::span<const Lamp> lamps, const std::vector<float>& grown,
               std::vector<core::Bounds>& boxes);

}  // namespace gr
