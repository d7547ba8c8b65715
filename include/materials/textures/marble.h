// Veins.
#pragma once

#include "materials/textures/colour_map.h"
#include "materials/textures/lattice_noise.h"

#include <span>
#include <string_view>

namespace materials {

// From 0 up to 1 and down again along each unit of x, stirred.
struct Marble : Pattern {
    static constexpr std::string_view typeName = "marble";

    Marble() { turbulence = 1; }

    static std::span<const core::OptionRow<Marble>> options() {
        static const auto rows = withMapping<Marble>(
            patternRows<Marble>("of the noise that stirs it, each twice as fine and half as high as the one before"));
        return rows;
    }

    template<class Real>
    core::Rgb<Real> at(const core::Vec3<Real>& own, const TexturePlace<Real>& place) const {
        const core::Vec3<Real> units = own * Real(static_cast<float>(frequency));
        const core::Vec3<Real> p =
            LatticeNoise<Real>::stirred(units, static_cast<float>(turbulence), octaves, seedBits());
        const Real part = core::Whole<Real>(p.x).rest;
        return mapped<Real>(map, Real(1) - core::abs(part * Real(2) - Real(1)), place);
    }
};

}  // namespace materials
