// Clouds.
#pragma once

#include "materials/textures/pattern.h"

#include <string_view>

namespace materials {

// Noise about one half; a feature of the first octave is about one unit wide.
struct Noise : PatternOf<Noise> {
    static constexpr std::string_view typeName = "noise";
    static constexpr std::string_view octavesHelp =
        "of the noise, and of that which stirs it, each twice as fine and half as high as the one before";

    template<class Real>
    Real number(const core::Vec3<Real>& p) const {
        const Real noise = LatticeNoise<Real>::octaves(p, octaves, seedBits());
        return core::min(core::max(Real(0.5f) + noise * Real(0.5f), Real(0)), Real(1));
    }
};

}  // namespace materials
