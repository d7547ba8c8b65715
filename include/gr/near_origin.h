// Where a space's own origin should be.
#pragma once

#include "core/vec.h"

namespace gr {

// In the middle of what lies from `low` to `high`, if that is farther away than it is large, so that no digits are
// spent on telling how far. Else where it is, so that numbers stay as they were given.
inline glm::dvec3 nearOrigin(const glm::dvec3& low, const glm::dvec3& high) {
    const glm::dvec3 middle = 0.5 * (low + high);
    return core::largestComponent(middle) > 2 * core::largestComponent(high - low) ? middle : glm::dvec3(0);
}

}  // namespace gr
