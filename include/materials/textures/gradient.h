// A ramp upwards.
#pragma once

#include "materials/textures/colour_map.h"
#include "materials/textures/lattice_noise.h"

#include <span>
#include <string_view>

namespace materials {

// From 0 to 1 along each unit of y, again and again.
struct Gradient : Pattern {
    static constexpr std::string_view typeName = "gradient";

    static std::span<const core::OptionRow<Gradient>> options() {
        static const auto rows = withMapping<Gradient>(
            patternRows<Gradient>("of the noise that stirs it, each twice as fine and half as high as the one before"));
        return rows;
    }

    template<class Real>
    core::Rgb<Real> at(const core::Vec3<Real>& own, const TexturePlace<Real>& place) const {
        const core::Vec3<Real> units = own * Real(static_cast<float>(frequency));
        const core::Vec3<Real> p =
            LatticeNoise<Real>::stirred(units, static_cast<float>(turbulence), octaves, seedBits());
        return mapped<Real>(map, core::Whole<Real>(p.y).rest, place);
    }
};

}  // namespace materials
