#include "materials/textures/texture_place.h"

#include <glm/ext/matrix_transform.hpp>

namespace materials {

core::Transform Mapping::toTexture() const {
    glm::dmat4 placed = glm::translate(glm::dmat4(1), translate);
    constexpr double radians = 3.14159265358979323846 / 180;
    for (int axis = 2; axis >= 0; --axis) {
        glm::dvec3 about(0);
        about[axis] = 1;
        if (rotate[axis] != 0) placed = glm::rotate(placed, rotate[axis] * radians, about);
    }
    return core::Transform(glm::inverse(glm::scale(placed, scale.by)));
}

}  // namespace materials
