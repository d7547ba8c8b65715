// Colours of vertices, which PLY and OBJ files have as a screen takes them.
#pragma once

#include "core/vec.h"

#include <algorithm>
#include <cmath>

namespace gr::importer {

// encoded: from 0 to 1, else the nearer of the two; the inverse of the sRGB curve (IEC 61966-2-1).
inline core::Rgbf fromSrgb(const glm::dvec3& encoded) {
    const auto linear = [](double x) {
        x = std::clamp(x, 0., 1.);
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return {linear(encoded.x), linear(encoded.y), linear(encoded.z)};
}

}  // namespace gr::importer
