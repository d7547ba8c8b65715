// Metals, plastics, varnish: Ashikhmin and Shirley, "An Anisotropic Phong BRDF Model" (Journal of Graphics Tools 5(2),
// 2000). A highlight about the mirror's direction whose width differs along u and v, over a diffuse base that fades
// where the highlight is strong.
#pragma once

#include "core/elementary.h"
#include "materials/interior.h"
#include "materials/methods.h"
#include "materials/option_rows.h"

namespace materials {

// The highlight's half vectors h are spread about the normal with density
//   sqrt((nu + 1)(nv + 1)) / 2pi * (n.h)^(nu cos^2 phi + nv sin^2 phi)          (the paper's equation 6)
// and light is mirrored by them.
struct ShirleyHalfVector {
    float nu, nv;

    // The density of wi (equation 8): a cone of half vectors makes one of directions, 4 (k.h) times as wide.
    template<class Real>
    Real pdfW(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        const core::Vec3<Real> sum = wo + wi;
        // Not 0 where both are all but along the surface, and opposite.
        const Real length = core::max(core::sqrt(glm::dot(sum, sum)), Real(1e-18f));
        return density(sum / length) / (Real(2) * length);  // k.h is half the length
    }

    // Equations 9 and 10. Below the surface where light would leave it to the inside.
    template<class Real>
    core::Vec3<Real> direction(const core::Vec3<Real>& wo, const core::Vec2<Real>& u) const {
        // tan(phi) = sqrt((nu + 1) / (nv + 1)) tan(turn), in all four quadrants at once.
        const core::SinCos<Real> turn = core::sinCosTurns(u.x);
        const Real x = turn.cos * Real(std::sqrt(nv + 1)), y = turn.sin * Real(std::sqrt(nu + 1));
        const Real x2 = x * x, y2 = y * y;
        // cos(theta) = (1 - u)^(1 / (exponent + 1)), and its sine without cancellation.
        const Real exponent = (Real(nu) * x2 + Real(nv) * y2) / (x2 + y2);
        const Real logCosine2 = core::log(Real(1) - u.y) * (Real(2) / (exponent + Real(1)));
        const Real sine2 = -core::expm1(logCosine2);
        const Real cosine = core::sqrt(core::max(Real(0), Real(1) - sine2));
        const Real scale = core::sqrt(sine2 / (x2 + y2));
        const core::Vec3<Real> h(x * scale, y * scale, cosine);
        return h * (Real(2) * glm::dot(wo, h)) - wo;
    }

private:
    // (n.h)^e with e = (nu x^2 + nv y^2) / s, s = x^2 + y^2 = 1 - (n.h)^2, is exp((nu x^2 + nv y^2) ln(1 - s) / 2s).
    template<class Real>
    Real density(const core::Vec3<Real>& h) const {
        const Real x2 = h.x * h.x, y2 = h.y * h.y;
        const Real power = (Real(nu) * x2 + Real(nv) * y2) * logOverSquare(x2 + y2, h.z);
        return Real(std::sqrt((nu + 1) * (nv + 1)) / (2 * core::pi)) * core::exp(power);
    }

    // ln(1 - s) / 2s. Near the normal, where 1 - s has lost the digits of s, from ln(1 - s) = -2 artanh(s / (2 - s)).
    template<class Real>
    static Real logOverSquare(const Real& s, const Real& cosine) {
        const Real z = s / (Real(2) - s), z2 = z * z;
        const Real series =
            (Real(1) + z2 * (Real(1 / 3.f) + z2 * (Real(1 / 5.f) + z2 * Real(1 / 7.f)))) / (s - Real(2));
        const Real smallest(1e-18f);
        const Real direct = core::log(core::max(cosine, smallest)) / core::max(s, smallest);
        return core::select(s < Real(0.25f), series, direct);
    }
};

struct Shirley {
    static constexpr std::string_view typeName = "shirley";
    static constexpr std::array<bool, 4> canSample{true, true, false, true};  // as Methods lists them

    static constexpr double mostExponent = 1e6;

    core::Rgbf diffuse{0.5f};  // R_d, each in [0, 1]
    core::Rgbf specular{0.5f};  // R_s, each in [0, 1]
    core::Vec2f exponents{100, 100};  // nu, nv
    std::optional<core::Weights> sampling{};
    double perturbation = 5;  // degrees

    static std::span<const core::OptionRow<Shirley>> options() {
        static const std::array<core::OptionRow<Shirley>, 5> rows{{
            {.name = "diffuse",
             .member = &Shirley::diffuse,
             .range = core::unitInterval,
             .help = "R_d, what the base reflects in all directions"},
            {.name = "specular",
             .member = &Shirley::specular,
             .range = core::unitInterval,
             .help = "R_s, what the highlight reflects of light along the normal"},
            {.name = "exp",
             .member = &Shirley::exponents,
             .range = {.least = 0, .most = mostExponent},
             .form = "{nu nv}",
             .help = "how narrow the highlight is along the surface's u and v axis"},
            samplingRow<Shirley>("a and d, by what base and highlight reflect"),
            perturbationRow<Shirley>(core::Range{.least = 0, .most = 90, .leastIncluded = false}),
        }};
        return rows;
    }

    bool isAnisotropic() const { return exponents.x != exponents.y; }
    std::optional<Interior> interior() const { return std::nullopt; }  // it is opaque

    // f * |cos|, f per steradian: equations 4 and 5, Schlick's approximation of Fresnel's equations in both.
    template<class Real>
    core::Rgb<Real> eval(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        const core::Mask<Real> reflects = (wo.z > Real(0)) & (wi.z > Real(0));
        const core::Vec3<Real> sum = wo + wi;
        const Real cosine = Real(0.5f) * core::sqrt(glm::dot(sum, sum));  // k.h
        const Real narrow = halfVector().pdfW(wo, wi) * (wi.z / core::max(wo.z, wi.z));
        const core::Rgb<Real> highlight = fresnel(cosine) * narrow;
        // 28 / 23pi keeps the sum of both below what arrives.
        const Real fading = (Real(1) - fifthPower(Real(1) - wi.z / Real(2))) *
                            (Real(1) - fifthPower(Real(1) - wo.z / Real(2))) * Real(28 / (23 * core::pi));
        const core::Rgb<Real> base = core::broadcast<Real>(diffuse * (1.f - specular)) * (fading * wi.z);
        return core::select(reflects, highlight + base, core::Rgb<Real>(Real(0)));
    }

    template<class Real, class Hemisphere = core::UniformHemisphere>
    Real pdfW(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        return methods<Real, Hemisphere>(wo).pdfW(wo, wi);
    }

    template<class Real, class Hemisphere = core::UniformHemisphere>
    BsdfSample<Real> sample(const core::Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real&) const {
        return methods<Real, Hemisphere>(wo).sample(wo, u, [&](const core::Vec3<Real>& wi) { return eval(wo, wi); });
    }

    // What the albedo layer of a picture shows: about what it reflects, seen along the normal.
    core::Rgbf albedo() const { return specular + diffuse * (1.f - specular); }
    // What `ambient` is multiplied with.
    core::Rgbf ambientReflectance() const { return diffuse; }

private:
    template<class Real>
    static Real fifthPower(const Real& x) {
        const Real x2 = x * x;
        return x2 * x2 * x;
    }

    template<class Real>
    core::Rgb<Real> fresnel(const Real& cosine) const {
        const Real grazing = fifthPower(core::max(Real(0), Real(1) - cosine));
        return core::broadcast<Real>(specular) + core::broadcast<Real>(1.f - specular) * grazing;
    }

    ShirleyHalfVector halfVector() const { return {exponents.x, exponents.y}; }

    // The highlight is drawn as often as it reflects more than the base, seen from wo.
    template<class Real, class Hemisphere>
    OpaqueMethods<Real, ShirleyHalfVector, Hemisphere> methods(const core::Vec3<Real>& wo) const {
        if (sampling) return {methodsOf<Real>(*sampling), perturbation, halfVector()};
        const auto sum = [](const auto& colour) { return colour.x + colour.y + colour.z; };
        const Real highlight = sum(fresnel(wo.z));
        const Real base(sum(diffuse * (1.f - specular)));
        const core::Mask<Real> reflects = highlight + base > Real(0);
        const Real part = core::select(reflects, highlight / (highlight + base), Real(0));
        return {{.diffuse = Real(1) - part, .shirley = part}, perturbation, halfVector()};
    }
};

}  // namespace materials
