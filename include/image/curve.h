// How a picture to look at is made of radiance: the curves that the numbers of a .png go through.
#pragma once

#include "core/option.h"

#include <cstdint>
#include <span>

namespace image {

enum class Curve {
    srgb,  // that of sRGB; what is above 1 is cut off
    linear,  // none: numbers in proportion to the radiance, cut off likewise
    filmic  // bright light is pressed together before the curve of sRGB, so that it keeps its shades
};

std::span<const core::Word> curveNames();
Curve curveNamed(core::Word name);

// What is shown of a radiance, from 0 to 1, in proportion to a screen's light; 1 from a radiance of 5.6 on. Hable's
// curve ("Uncharted 2: HDR Lighting", Game Developers Conference 2010), a ratio of quadratics with a toe and a
// shoulder, with his constants: what is there for a film's response, white 11.2 and a radiance that counts twice.
// Monotone; 0 for 0 and less.
double filmic(double radiance);

// The number in 8 bits.
std::uint8_t toByte(Curve curve, float radiance);

// What a file of such numbers says that light was raised to, as Image::gamma has it. A reader of filmic numbers finds
// what is shown, not the radiance: no power makes that good.
double gammaOf(Curve curve);

struct ViewTransform {
    double exposure;  // stops
    Curve curve;

    ViewTransform(double exposure = 0, Curve curve = Curve::srgb) : exposure(exposure), curve(curve) {}
};

}  // namespace image
