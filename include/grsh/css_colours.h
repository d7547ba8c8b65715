// Colours as the web writes them: by name (CSS Color Module Level 4, section 6.1) or as #rrggbb.
#pragma once

#include "core/vec.h"

#include <optional>
#include <span>
#include <string_view>

namespace grsh {

// Linear, each from 0 to 1; nothing where the word is neither a name, in small letters or capitals, nor # and six
// hexadecimal digits.
std::optional<core::Rgbf> cssColour(std::string_view word);

// All 148, in the alphabet's order.
std::span<const std::string_view> cssColourNames();

}  // namespace grsh
