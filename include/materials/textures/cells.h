// Blocks, each of a number of its own.
#pragma once

#include "materials/textures/colour_map.h"
#include "materials/textures/lattice_noise.h"

#include <span>
#include <string_view>

namespace materials {

// Cubes of one unit, whose numbers chance has drawn.
struct Cells : Pattern {
    static constexpr std::string_view typeName = "cells";

    static std::span<const core::OptionRow<Cells>> options() {
        static const auto rows = withMapping<Cells>(
            patternRows<Cells>("of the noise that stirs it, each twice as fine and half as high as the one before"));
        return rows;
    }

    template<class Real>
    core::Rgb<Real> at(const core::Vec3<Real>& own, const TexturePlace<Real>& place) const {
        const core::Vec3<Real> units = own * Real(static_cast<float>(frequency));
        const core::Vec3<Real> p =
            LatticeNoise<Real>::stirred(units, static_cast<float>(turbulence), octaves, seedBits());
        const auto cell = [&](int axis) { return core::Whole<Real>(p[axis] + Real(onFace)).number; };
        const auto hash = cellHash<core::UInt<Real>>(cell(0), cell(1), cell(2), seedBits());
        return mapped<Real>(map, core::toReal(core::UInt<Real>(hash >> 8)) * Real(0x1p-24f), place);
    }
};

}  // namespace materials
