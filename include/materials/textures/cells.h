// Blocks, each of a number of its own.
#pragma once

#include "materials/textures/pattern.h"

#include <string_view>

namespace materials {

// Cubes of one unit, whose numbers chance has drawn.
struct Cells : PatternOf<Cells> {
    static constexpr std::string_view typeName = "cells";

    template<class Real>
    Real number(const core::Vec3<Real>& p) const {
        const auto cell = [&](int axis) { return core::Whole<Real>(p[axis] + Real(onFace)).number; };
        const auto hash = cellHash<core::UInt<Real>>(cell(0), cell(1), cell(2), seedBits());
        return core::toReal(core::UInt<Real>(hash >> 8)) * Real(0x1p-24f);
    }
};

}  // namespace materials
