// What the nodes of shapes have in common: the scene graph's words for a shape, as scripts give them.
#pragma once

#include "core/option.h"

#include <glm/ext/matrix_transform.hpp>
#include <string>

namespace gr {

// The map of a shape's own space into its node's surroundings: its origin goes to `centre`, its units become `size`.
inline glm::dmat4 shapePlace(const glm::dmat4& around, const glm::dvec3& centre, const glm::dvec3& size) {
    return glm::scale(glm::translate(around, centre), size);
}

inline std::string vectorText(const glm::dvec3& v) {
    return "{" + core::numberText(v.x) + " " + core::numberText(v.y) + " " + core::numberText(v.z) + "}";
}

// Words with a blank between them.
template<class... Numbers>
std::string nodeText(const glm::dvec3& v, Numbers... numbers) {
    return vectorText(v) + ((" " + core::numberText(numbers)) + ...);
}

}  // namespace gr
