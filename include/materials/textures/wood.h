// Rings.
#pragma once

#include "materials/textures/colour_map.h"
#include "materials/textures/lattice_noise.h"

#include <span>
#include <string_view>

namespace materials {

// Round the z axis, from 0 up to 1 and down again within each unit from it, stirred a little.
struct Wood : Pattern {
    static constexpr std::string_view typeName = "wood";

    Wood() { turbulence = 0.1; }

    static std::span<const core::OptionRow<Wood>> options() {
        static const auto rows = withMapping<Wood>(
            patternRows<Wood>("of the noise that stirs it, each twice as fine and half as high as the one before"));
        return rows;
    }

    template<class Real>
    core::Rgb<Real> at(const core::Vec3<Real>& own, const TexturePlace<Real>& place) const {
        const core::Vec3<Real> units = own * Real(static_cast<float>(frequency));
        const core::Vec3<Real> p =
            LatticeNoise<Real>::stirred(units, static_cast<float>(turbulence), octaves, seedBits());
        const Real part = core::Whole<Real>(core::sqrt(p.x * p.x + p.y * p.y)).rest;
        return mapped<Real>(map, Real(1) - core::abs(part * Real(2) - Real(1)), place);
    }
};

}  // namespace materials
