// Ashikhmin and Shirley's model in double, as their paper (2000) writes it: k1 towards the viewer, k2 towards the
// light, n the normal (z), u and v the tangents (x and y).
#pragma once

#include <sstream>
#include <string>

#include "materials/bsdf_checks.h"
#include "materials/shirley.h"

namespace materials {

struct ShirleyPaper {
    double nu, nv;

    static constexpr double pi = std::numbers::pi;

    // The same for k1 and k2; the mean of both is less touched by what rounding does to their lengths.
    static double cosineToHalf(const glm::dvec3& k1, const glm::dvec3& k2) {
        const glm::dvec3 h = glm::normalize(k1 + k2);
        return (glm::dot(k1, h) + glm::dot(k2, h)) / 2;
    }

    // Equation 4 without F(k.h).
    double highlightWithoutFresnel(const glm::dvec3& k1, const glm::dvec3& k2) const {
        const glm::dvec3 h = glm::normalize(k1 + k2);
        // 1 - (h.n)^2 without its rounding, which rules near the normal.
        const double sine2 = h.x * h.x + h.y * h.y;
        const double exponent = sine2 > 0 ? (nu * h.x * h.x + nv * h.y * h.y) / sine2 : 0;
        const double power = std::exp(exponent * 0.5 * std::log1p(-sine2));
        return std::sqrt((nu + 1) * (nv + 1)) / (8 * pi) * power / (cosineToHalf(k1, k2) * std::max(k1.z, k2.z));
    }

    // Equation 3: Schlick's approximation.
    static double fresnel(double rs, const glm::dvec3& k1, const glm::dvec3& k2) {
        return rs + (1 - rs) * std::pow(1 - cosineToHalf(k1, k2), 5);
    }

    // Equation 5.
    static double base(double rd, double rs, const glm::dvec3& k1, const glm::dvec3& k2) {
        return 28 * rd / (23 * pi) * (1 - rs) * (1 - std::pow(1 - k1.z / 2, 5)) * (1 - std::pow(1 - k2.z / 2, 5));
    }
};

// f of the paper for a material of ours.
inline glm::dvec3 paperF(const Shirley& material, const core::Vec3f& k1, const core::Vec3f& k2) {
    const glm::dvec3 wo(k1), wi(k2);
    const ShirleyPaper paper{material.exponents.value.x, material.exponents.value.y};
    const double highlight = paper.highlightWithoutFresnel(wo, wi);
    glm::dvec3 f;
    for (int channel = 0; channel < 3; ++channel) {
        const double rs = material.specular.value[channel], rd = material.diffuse.value[channel];
        f[channel] = highlight * ShirleyPaper::fresnel(rs, wo, wi) + ShirleyPaper::base(rd, rs, wo, wi);
    }
    return f;
}

// The first pair of directions for which eval is not the paper's. Rounding shows in the base at grazing, where it is
// small, and in the tail of a highlight, where the logarithm of (h.n)^exponent is up to 87.
template<class M>
std::string firstPaperFault(const M& material) {
    const auto bsdf = bsdfOf(material);
    support::TestRandom random(7);
    for (int i = 0; i < 100'000; ++i) {
        const core::Vec3f wo = nextDirection(random);
        const bool isNear = i % 2 == 0;
        const core::Vec3f wi =
            isNear ? nextDirectionNear(mirrored(wo), lobeWidth(material), random) : nextDirection(random);
        if (wo.z <= 0 || wi.z <= 0) continue;
        const core::Rgbf f = bsdf.eval(wo, wi) / wi.z;
        const glm::dvec3 expected = paperF(material, wo, wi);
        for (int channel = 0; channel < 3; ++channel) {
            if (std::abs(f[channel] - expected[channel]) <= 3e-5 * expected[channel] + 3e-7) continue;
            std::ostringstream fault;
            fault << "from " << text(wo) << " to " << text(wi) << " f is " << f[channel] << ", the paper's "
                  << expected[channel];
            return fault.str();
        }
    }
    return "";
}

}  // namespace materials
