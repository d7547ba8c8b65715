// What the colours of a picture are made of.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace image {

// The chromaticities x and y of red, green, blue and white.
using Primaries = std::array<double, 8>;

// Those of sRGB (ITU-R BT.709), which all colours here have.
inline constexpr Primaries srgbPrimaries{0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};

// Why a file of these primaries is not read; nothing where they are those of sRGB, but for rounding.
std::optional<std::string> otherThanSrgb(const Primaries& primaries);

}  // namespace image
