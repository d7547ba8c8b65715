// Boxes along the axes.
#pragma once

#include "core/vec.h"

namespace core {

struct Bounds {
    Vec3f low{infinity}, high{-infinity};  // empty

    void include(const Vec3f& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void include(const Bounds& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    bool isEmpty() const { return low.x > high.x || low.y > high.y || low.z > high.z; }
    Vec3f size() const { return high - low; }
    // The largest absolute coordinate.
    float reach() const { return max(largestComponent(low), largestComponent(high)); }
    Bounds widened(float by) const { return {low - by, high + by}; }
    Bounds intersection(const Bounds& other) const { return {glm::max(low, other.low), glm::min(high, other.high)}; }
};

}  // namespace core
