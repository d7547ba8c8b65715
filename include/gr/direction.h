// Directions in double precision, of any length but 0: also of one whose square is no number.
#pragma once

#include "core/vec.h"

#include <algorithm>
#include <cmath>

namespace gr {

inline glm::dvec3 directionOf(const glm::dvec3& v) {
    return glm::normalize(v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

// The sine of the angle between them; 0 where they are parallel.
inline double sineBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(glm::cross(directionOf(a), directionOf(b)));
}

}  // namespace gr
