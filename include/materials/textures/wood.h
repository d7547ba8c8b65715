// Rings.
#pragma once

#include "materials/textures/pattern.h"

#include <string_view>

namespace materials {

// Round the z axis, from 0 up to 1 and down again within each unit from it, stirred a little.
struct Wood : PatternOf<Wood> {
    static constexpr std::string_view typeName = "wood";

    Wood() { turbulence = 0.1; }

    template<class Real>
    Real number(const core::Vec3<Real>& p) const {
        return upAndDown<Real>(core::sqrt(p.x * p.x + p.y * p.y));
    }
};

}  // namespace materials
