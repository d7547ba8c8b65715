// Ashikhmin and Shirley's model: see shirley.h. Its equations have the paper's numbers.
#pragma once

#include "core/elementary.h"
#include "core/option.h"
#include "core/vec.h"
#include "core/warp.h"
#include "materials/bsdf.h"
#include "materials/methods.h"

#include <optional>

namespace materials {

// The highlight's half vectors h are spread about the normal with density
//   sqrt((nu + 1)(nv + 1)) / 2pi * (n.h)^(nu cos^2 phi + nv sin^2 phi)          (the paper's equation 6)
// and light is mirrored by them.
template<class Real>
struct ShirleyHalfVector {
    Real nu, nv;
    Real peak = core::sqrt((nu + Real(1)) * (nv + Real(1))) / Real(2 * core::pi);  // where h is the normal

    // The density of wi (equation 8): a cone of half vectors makes one of directions, 4 (k.h) times as wide.
    Real pdfW(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        const core::Vec3<Real> sum = wo + wi;
        // Not 0 where both are all but along the surface, and opposite.
        const Real length = core::max(core::sqrt(glm::dot(sum, sum)), Real(1e-18f));
        return density(sum / length) / (Real(2) * length);  // k.h is half the length
    }

    // Equations 9 and 10. Below the surface where light would leave it to the inside.
    core::Vec3<Real> direction(const core::Vec3<Real>& wo, const core::Vec2<Real>& u) const {
        // tan(phi) = sqrt((nu + 1) / (nv + 1)) tan(turn), in all four quadrants at once.
        const core::SinCos<Real> turn = core::sinCosTurns(u.x);
        const Real x = turn.cos * core::sqrt(nv + Real(1)), y = turn.sin * core::sqrt(nu + Real(1));
        const Real x2 = x * x, y2 = y * y;
        // cos(theta) = (1 - u)^(1 / (exponent + 1)), and its sine without cancellation.
        const Real exponent = (nu * x2 + nv * y2) / (x2 + y2);
        const Real logCosine2 = core::log(Real(1) - u.y) * (Real(2) / (exponent + Real(1)));
        const Real sine2 = -core::expm1(logCosine2);
        const Real cosine = core::sqrt(core::max(Real(0), Real(1) - sine2));
        const Real scale = core::sqrt(sine2 / (x2 + y2));
        const core::Vec3<Real> h(x * scale, y * scale, cosine);
        return h * (Real(2) * glm::dot(wo, h)) - wo;
    }

private:
    // (n.h)^e with e = (nu x^2 + nv y^2) / s, s = x^2 + y^2 = 1 - (n.h)^2, is exp((nu x^2 + nv y^2) ln(1 - s) / 2s).
    Real density(const core::Vec3<Real>& h) const {
        const Real x2 = h.x * h.x, y2 = h.y * h.y;
        const Real power = (nu * x2 + nv * y2) * logOverSquare(x2 + y2, h.z);
        return peak * core::exp(power);
    }

    // ln(1 - s) / 2s. Near the normal, where 1 - s has lost the digits of s, from ln(1 - s) = -2 artanh(s / (2 - s)).
    static Real logOverSquare(const Real& s, const Real& cosine) {
        const Real z = s / (Real(2) - s), z2 = z * z;
        const Real series =
            (Real(1) + z2 * (Real(1 / 3.f) + z2 * (Real(1 / 5.f) + z2 * Real(1 / 7.f)))) / (s - Real(2));
        const Real smallest(1e-18f);
        const Real direct = core::log(core::max(cosine, smallest)) / core::max(s, smallest);
        return core::select(s < Real(0.25f), series, direct);
    }
};

template<class Real>
struct ShirleyBsdf {
    core::Rgb<Real> diffuse, specular;  // R_d, R_s
    ShirleyHalfVector<Real> halfVector;
    std::optional<core::Weights> sampling;
    double perturbation;  // degrees

    // f * |cos|, f per steradian: equations 4 and 5, Schlick's approximation of Fresnel's equations in both.
    core::Rgb<Real> eval(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        const core::Mask<Real> reflects = (wo.z > Real(0)) & (wi.z > Real(0));
        const core::Vec3<Real> sum = wo + wi;
        const Real cosine = Real(0.5f) * core::sqrt(glm::dot(sum, sum));  // k.h
        const Real narrow = halfVector.pdfW(wo, wi) * (wi.z / core::max(wo.z, wi.z));
        const core::Rgb<Real> highlight = fresnel(cosine) * narrow;
        // 28 / 23pi keeps the sum of both below what arrives.
        const Real fading = (Real(1) - fifthPower(Real(1) - wi.z / Real(2))) *
                            (Real(1) - fifthPower(Real(1) - wo.z / Real(2))) * Real(28 / (23 * core::pi));
        const core::Rgb<Real> scattered = base() * (fading * wi.z);
        return core::select(reflects, highlight + scattered, core::Rgb<Real>(Real(0)));
    }

    template<class Hemisphere = core::UniformHemisphere>
    Real pdfW(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        return methods<Hemisphere>(wo).pdfW(wo, wi);
    }

    template<class Hemisphere = core::UniformHemisphere>
    BsdfSample<Real> sample(const core::Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real&) const {
        return methods<Hemisphere>(wo).sample(wo, u, [&](const core::Vec3<Real>& wi) { return eval(wo, wi); });
    }

private:
    static Real fifthPower(const Real& x) {
        const Real x2 = x * x;
        return x2 * x2 * x;
    }

    core::Rgb<Real> fresnel(const Real& cosine) const {
        const Real grazing = fifthPower(core::max(Real(0), Real(1) - cosine));
        return specular + (Real(1) - specular) * grazing;
    }

    // What the base reflects of the light that passes the highlight along the normal.
    core::Rgb<Real> base() const { return diffuse * (Real(1) - specular); }

    // The highlight is drawn as often as it reflects more than the base, seen from wo.
    template<class Hemisphere>
    OpaqueMethods<Real, ShirleyHalfVector<Real>, Hemisphere> methods(const core::Vec3<Real>& wo) const {
        if (sampling) return {methodsOf<Real>(*sampling), perturbation, halfVector};
        const auto sum = [](const core::Rgb<Real>& colour) { return colour.x + colour.y + colour.z; };
        const Real highlight = sum(fresnel(wo.z)), both = highlight + sum(base());
        const Real part = core::select(both > Real(0), highlight / both, Real(0));
        return {{.diffuse = Real(1) - part, .shirley = part}, perturbation, halfVector};
    }
};

}  // namespace materials
