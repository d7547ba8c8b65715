// The laws that pictures of glass and of Shirley's materials are held against, in double and written down otherwise
// than the renderer has them.
#pragma once

#include "render/test_scene.h"

#include <cmath>
#include <numbers>

namespace render {

// What a smooth surface reflects of unpolarised light that comes at this angle (radians, > 0) to the normal: Fresnel's
// own two formulas. n: of refraction, beyond over before.
inline double fresnel(double angle, double n) {
    const double refracted = std::asin(std::sin(angle) / n);
    const double across = std::sin(angle - refracted) / std::sin(angle + refracted);
    const double along = std::tan(angle - refracted) / std::tan(angle + refracted);
    return (across * across + along * along) / 2;
}

// The same at right angles.
inline double normalReflectance(double n) {
    return (n - 1) * (n - 1) / ((n + 1) * (n + 1));
}

// Ashikhmin and Shirley's f * cos of a channel, by the paper's equations 3 to 5: k1 and k2 are unit vectors in the
// surface's frame, z its normal.
inline double shirleyEval(const materials::Shirley& m, int channel, const glm::dvec3& k1, const glm::dvec3& k2) {
    if (k1.z <= 0 || k2.z <= 0) return 0;
    const double rd = m.diffuse.value[channel], rs = m.specular.value[channel], nu = m.exponents.value.x,
                 nv = m.exponents.value.y;
    const glm::dvec3 h = glm::normalize(k1 + k2);
    const double kh = glm::dot(k1, h), sine2 = h.x * h.x + h.y * h.y;
    const double exponent = sine2 > 0 ? (nu * h.x * h.x + nv * h.y * h.y) / sine2 : 0;
    const double fresnel = rs + (1 - rs) * std::pow(1 - kh, 5);
    const double specular = std::sqrt((nu + 1) * (nv + 1)) / (8 * std::numbers::pi) * std::pow(h.z, exponent) /
                            (kh * std::max(k1.z, k2.z)) * fresnel;
    const auto fading = [](double cosine) { return 1 - std::pow(1 - cosine / 2, 5); };
    const double diffuse = 28 * rd / (23 * std::numbers::pi) * (1 - rs) * fading(k1.z) * fading(k2.z);
    return (specular + diffuse) * k2.z;
}

}  // namespace render
