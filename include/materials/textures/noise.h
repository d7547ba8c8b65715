// Clouds.
#pragma once

#include "materials/textures/colour_map.h"
#include "materials/textures/lattice_noise.h"

#include <span>
#include <string_view>

namespace materials {

// Noise about 1/2; a feature of the first octave is about one unit wide.
struct Noise : Pattern {
    static constexpr std::string_view typeName = "noise";

    static std::span<const core::OptionRow<Noise>> options() {
        static const auto rows = withMapping<Noise>(patternRows<Noise>(
            "of the noise, and of that which stirs it, each twice as fine and half as high as the one before"));
        return rows;
    }

    template<class Real>
    core::Rgb<Real> at(const core::Vec3<Real>& own, const TexturePlace<Real>& place) const {
        const core::Vec3<Real> units = own * Real(static_cast<float>(frequency));
        const core::Vec3<Real> p =
            LatticeNoise<Real>::stirred(units, static_cast<float>(turbulence), octaves, seedBits());
        const Real noise = LatticeNoise<Real>::octaves(p, octaves, seedBits());
        return mapped<Real>(map, core::min(core::max(Real(0.5f) + noise * Real(0.5f), Real(0)), Real(1)), place);
    }
};

}  // namespace materials
