// Colours of vertices, which PLY and OBJ files have as a screen takes them.
#pragma once

#include "core/srgb.h"
#include "core/vec.h"

#include <algorithm>

namespace gr::importer {

// encoded: from 0 to 1, else the nearer of the two.
inline core::Rgbf fromSrgb(const glm::dvec3& encoded) {
    const auto linear = [](double x) { return core::decodeSrgb(std::clamp(x, 0., 1.)); };
    return {linear(encoded.x), linear(encoded.y), linear(encoded.z)};
}

}  // namespace gr::importer
