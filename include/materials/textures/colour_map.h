// Numbers become colours, or textures: POV-Ray's colour maps.
#pragma once

#include "core/option.h"
#include "materials/textures/texture_place.h"

namespace materials {

// A colour, or what the texture in its place has there.
template<class Real>
core::Rgb<Real> colourAt(const core::Textured<core::Rgbf>& colour, const TexturePlace<Real>& place);  // texture.h

inline core::ColourStops blackToWhite() {
    return {{0, core::Rgbf(0)}, {1, core::Rgbf(1)}};
}

// stops: at least one, in rising order. Before the first there is the first colour, behind the last the last.
template<class Real>
core::Rgb<Real> mapped(const core::ColourStops& stops, const Real& t, const TexturePlace<Real>& place) {
    core::Rgb<Real> colour = colourAt<Real>(stops[0].colour, place);
    core::Rgb<Real> before = colour;
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const auto from = static_cast<float>(stops[i - 1].place), to = static_cast<float>(stops[i].place);
        const core::Rgb<Real> next = colourAt<Real>(stops[i].colour, place);
        const core::Mask<Real> isBehind = t >= Real(from);
        // Two stops at one place are a sharp edge.
        const Real part = to > from ? core::min((t - Real(from)) * Real(1 / (to - from)), Real(1)) : Real(1);
        colour = core::select(isBehind, before + (next - before) * part, colour);
        before = next;
    }
    return colour;
}

// The options of patterns that are numbers from 0 to 1, made colours.
struct Pattern : Mapping {
    core::ColourStops map = blackToWhite();
    double frequency = 1;
    int octaves = 6;
    double turbulence = 0;
    int seed = 0;

    std::uint32_t seedBits() const { return static_cast<std::uint32_t>(seed); }
};

template<class T>
std::array<core::OptionRow<T>, 5> patternRows(std::string_view octavesHelp) {
    return {
        {{.name = "map",
          .member = static_cast<core::ColourStops T::*>(&T::map),
          .range = {.least = 0, .most = 1e18},
          .defaultText = "{0 black 1 white}",
          .help = "the colours that the pattern's numbers stand for, places from 0 to 1 in rising order; textures may "
                  "stand for colours"},
         {.name = "frequency",
          .member = static_cast<double T::*>(&T::frequency),
          .range = {.least = 0, .most = 1e6, .leastIncluded = false},
          .help = "how often it repeats in a unit"},
         {.name = "octaves",
          .member = static_cast<int T::*>(&T::octaves),
          .range = {.least = 1, .most = 16},
          .help = octavesHelp},
         {.name = "turbulence",
          .member = static_cast<double T::*>(&T::turbulence),
          .range = {.least = 0, .most = 1e3},
          .help = "how far places are stirred, in units of the pattern"},
         {.name = "seed",
          .member = static_cast<int T::*>(&T::seed),
          .range = {.least = 0, .most = 2147483647},
          .help = "another number makes another pattern of the same kind"}}};
}

}  // namespace materials
