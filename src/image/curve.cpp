#include "image/curve.h"

#include "core/srgb.h"

#include <algorithm>
#include <array>

namespace image {
namespace {

// In the order of Curve.
constexpr std::array<core::Word, 3> names{"srgb", "linear", "filmic"};

double hable(double x) {
    constexpr double shoulder = 0.15, linear = 0.5, linearAngle = 0.1, toe = 0.2, toeNumerator = 0.02,
                     toeDenominator = 0.3;
    return (x * (shoulder * x + linearAngle * linear) + toe * toeNumerator) /
               (x * (shoulder * x + linear) + toe * toeDenominator) -
           toeNumerator / toeDenominator;
}

double shown(Curve curve, double radiance) {
    const double light = std::clamp(radiance, 0., 1.);
    switch (curve) {
        case Curve::linear:
            return light;
        case Curve::filmic:
            return core::encodeSrgb(filmic(radiance));
        case Curve::srgb:
            break;
    }
    return core::encodeSrgb(light);
}

}  // namespace

std::span<const core::Word> curveNames() {
    return names;
}

Curve curveNamed(core::Word name) {
    return static_cast<Curve>(std::find(names.begin(), names.end(), name) - names.begin());
}

double filmic(double radiance) {
    constexpr double white = 11.2, scale = 2;
    return std::clamp(hable(std::clamp(scale * radiance, 0., white)) / hable(white), 0., 1.);
}

std::uint8_t toByte(Curve curve, float radiance) {
    return static_cast<std::uint8_t>(shown(curve, static_cast<double>(radiance)) * 255 + 0.5);
}

double gammaOf(Curve curve) {
    return curve == Curve::linear ? 1 : 0;
}

}  // namespace image
