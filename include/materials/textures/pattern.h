// Patterns: numbers over space, which a map makes colours.
#pragma once

#include "core/floor.h"
#include "materials/textures/colour_map.h"
#include "materials/textures/lattice_noise.h"

#include <array>
#include <span>
#include <string_view>

namespace materials {

// The options of patterns that are numbers from 0 to 1, made colours.
struct Pattern : Mapping {
    core::ColourStops map = blackToWhite();
    double frequency = 1;
    int octaves = 6;
    double turbulence = 0;
    int seed = 0;

    std::uint32_t seedBits() const { return static_cast<std::uint32_t>(seed); }
};

// T: a pattern, which has a typeName and `number`, from 0 to 1, at a place in its own space, stirred already.
template<class T>
struct PatternOf : Pattern {
    static constexpr std::string_view octavesHelp =
        "of the noise that stirs it, each twice as fine and half as high as the one before";

    static std::span<const core::OptionRow<T>> options() {
        static const auto rows = withMapping<T>(ownRows());
        return rows;
    }

    template<class Real>
    core::Rgb<Real> at(const core::Vec3<Real>& own, const TexturePlace<Real>& place) const {
        const core::Vec3<Real> p = LatticeNoise<Real>::stirred(own * Real(static_cast<float>(frequency)),
                                                               static_cast<float>(turbulence), octaves, seedBits());
        return mapped<Real>(map, static_cast<const T&>(*this).template number<Real>(p), place);
    }

private:
    static std::array<core::OptionRow<T>, 5> ownRows() {
        return {
            {{.name = "map",
              .member = static_cast<core::ColourStops T::*>(&T::map),
              .range = {.least = 0, .most = 1e18},
              .defaultText = "{0 black 1 white}",
              .help =
                  "the colours that the pattern's numbers stand for, places from 0 to 1 in rising order; textures may "
                  "stand for colours"},
             {.name = "frequency",
              .member = static_cast<double T::*>(&T::frequency),
              .range = {.least = 0, .most = 1e6, .leastIncluded = false},
              .help = "how often it repeats in a unit"},
             {.name = "octaves",
              .member = static_cast<int T::*>(&T::octaves),
              .range = {.least = 1, .most = 16},
              .help = T::octavesHelp},
             {.name = "turbulence",
              .member = static_cast<double T::*>(&T::turbulence),
              .range = {.least = 0, .most = 1e3},
              .help = "how far places are stirred, in units of the pattern"},
             {.name = "seed",
              .member = static_cast<int T::*>(&T::seed),
              .range = {.least = 0, .most = 2147483647},
              .help = "another number makes another pattern of the same kind"}}};
    }
};

// From 0 up to 1 and down again within each unit.
template<class Real>
Real upAndDown(const Real& x) {
    return Real(1) - core::abs(core::Whole<Real>(x).rest * Real(2) - Real(1));
}

}  // namespace materials
