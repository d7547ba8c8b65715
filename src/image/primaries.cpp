#include "image/primaries.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace image {
namespace {

// Files round to 3 digits or so; the nearest others that are in use, those of SMPTE C, lie 0.01 away.
bool areAlike(const Primaries& a, const Primaries& b) {
    constexpr double most = 0.002;
    return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return std::abs(x - y) < most; });
}

struct Known {
    std::string_view name;
    Primaries primaries;
};

constexpr Known others[] = {
    {"Display P3", {0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290}},
    {"DCI-P3", {0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.314, 0.351}},
    {"BT.2020", {0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290}},
    {"Adobe RGB", {0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.3290}},
    {"ProPhoto RGB", {0.7347, 0.2653, 0.1596, 0.8404, 0.0366, 0.0001, 0.3457, 0.3585}},
    {"ACES (AP0)", {0.7347, 0.2653, 0, 1, 0.0001, -0.077, 0.32168, 0.33767}},
    {"ACEScg (AP1)", {0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767}},
    {"Radiance", {0.640, 0.330, 0.290, 0.600, 0.150, 0.060, 0.3333, 0.3333}},
    {"CIE XYZ", {1, 0, 0, 1, 0, 0, 0.3333, 0.3333}},
};

}  // namespace

std::optional<std::string> otherThanSrgb(const Primaries& primaries) {
    if (areAlike(primaries, srgbPrimaries)) return std::nullopt;
    for (const Known& known : others)
        if (areAlike(primaries, known.primaries))
            return "its primaries are those of " + std::string(known.name) + ", not of sRGB";
    return "its primaries are other than those of sRGB";
}

}  // namespace image
