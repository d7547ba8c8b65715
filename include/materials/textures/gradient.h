// A ramp upwards.
#pragma once

#include "materials/textures/pattern.h"

#include <string_view>

namespace materials {

// From 0 to 1 along each unit of y, again and again.
struct Gradient : PatternOf<Gradient> {
    static constexpr std::string_view typeName = "gradient";

    template<class Real>
    Real number(const core::Vec3<Real>& p) const {
        return core::Whole<Real>(p.y).rest;
    }
};

}  // namespace materials
