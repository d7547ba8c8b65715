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

}  // namespace materials
