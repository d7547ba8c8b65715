// Colour profiles that pictures bring with them (ISO 15076-1, ICC.1).
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace image {

using ProfileBytes = std::span<const std::uint8_t>;

// Whether a profile means the colours of sRGB, whatever it is called: colours are a sum of its red, green and blue, or
// grey, and both these and the curves are those of sRGB but for rounding. False for what is no profile.
bool isSrgbProfile(ProfileBytes profile);

// What the profile calls itself, in ASCII; empty where it does not say.
std::string nameOfProfile(ProfileBytes profile);

}  // namespace image
