// Veins.
#pragma once

#include "materials/textures/pattern.h"

#include <string_view>

namespace materials {

// From 0 up to 1 and down again along each unit of x, stirred.
struct Marble : PatternOf<Marble> {
    static constexpr std::string_view typeName = "marble";

    Marble() { turbulence = 1; }

    template<class Real>
    Real number(const core::Vec3<Real>& p) const {
        return upAndDown<Real>(p.x);
    }
};

}  // namespace materials
