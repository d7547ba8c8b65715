#include "gr/placement.h"

namespace gr {

AlignedMap::operator core::Transform() const {
    core::Transform map;
    for (int axis = 0; axis < 3; ++axis) {
        map.x[axis] = axis == 0 ? scale.x : 0;
        map.y[axis] = axis == 1 ? scale.y : 0;
        map.z[axis] = axis == 2 ? scale.z : 0;
    }
    map.translation = translation;
    return map;
}

core::Transform Placement::worldFromObject() const {
    if (const auto* aligned = std::get_if<Aligned>(&place_)) return aligned->worldFromObject;
    if (const auto* general = std::get_if<const General*>(&place_)) return (*general)->worldFromObject;
    return {};
}

core::Transform Placement::objectFromWorld() const {
    if (const auto* aligned = std::get_if<Aligned>(&place_)) return aligned->objectFromWorld;
    if (const auto* general = std::get_if<const General*>(&place_)) return (*general)->objectFromWorld;
    return {};
}

}  // namespace gr
