// Metals, plastics, varnish: Ashikhmin and Shirley, "An Anisotropic Phong BRDF Model" (Journal of Graphics Tools 5(2),
// 2000). A highlight about the mirror's direction whose width differs along u and v, over a diffuse base that fades
// where the highlight is strong.
#pragma once

#include "core/option.h"
#include "core/vec.h"
#include "materials/interior.h"
#include "materials/option_rows.h"
#include "materials/shirley_bsdf.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace materials {

struct Shirley {
    static constexpr std::string_view typeName = "shirley";
    static constexpr std::array<bool, 4> canSample{true, true, false, true};

    static constexpr double mostExponent = 1e6;

    core::Textured<core::Rgbf> diffuse{core::Rgbf(0.5f)};  // R_d, each in [0, 1]
    core::Textured<core::Rgbf> specular{core::Rgbf(0.5f)};  // R_s, each in [0, 1]
    core::Textured<core::Vec2f> exponents{core::Vec2f(100, 100)};  // nu, nv
    bool keepDiffuse = false;  // see keptOf()
    std::optional<core::Weights> sampling{};
    double perturbation = 5;  // degrees

    static std::span<const core::OptionRow<Shirley>> options() {
        static const std::array<core::OptionRow<Shirley>, 6> rows{{
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
            {.name = "keepdiffuse",
             .member = &Shirley::keepDiffuse,
             .help = "on: R_d is seen as it is, and R_s is less where both would be more than the light; off: "
                     "R_d (1 - R_s) is seen"},
            samplingRow<Shirley>("a and d, by what base and highlight reflect"),
            perturbationRow<Shirley>(core::Range{.least = 0, .most = 90, .leastIncluded = false}),
        }};
        return rows;
    }

    template<class Real, class Point>
    ShirleyBsdf<Real> at(const Point& point) const {
        const core::Rgb<Real> base = diffuse.at<Real>(point), highlight = specular.at<Real>(point);
        const core::Vec2<Real> narrow = exponents.at<Real>(point);
        if (!keepDiffuse) return {base, highlight, {narrow.x, narrow.y}, sampling, perturbation};
        const Shown<Real> kept = keptOf(base, highlight);
        return {kept.bare(), kept.highlight, {narrow.x, narrow.y}, sampling, perturbation};
    }

    bool isAnisotropic() const { return exponents.value.x != exponents.value.y; }
    std::optional<Interior> interior() const { return std::nullopt; }  // it is opaque
    // About that, seen along the normal.
    template<class Real, class Point>
    core::Rgb<Real> albedo(const Point& point) const {
        const core::Rgb<Real> base = diffuse.at<Real>(point), highlight = specular.at<Real>(point);
        if (!keepDiffuse) return highlight + base * (Real(1) - highlight);
        const Shown<Real> kept = keptOf(base, highlight);
        return kept.highlight + kept.base;
    }
    template<class Real, class Point>
    core::Rgb<Real> ambientReflectance(const Point& point) const {
        return diffuse.at<Real>(point);
    }

private:
    // What is seen along the normal; their sum is at most 1 in each channel.
    template<class Real>
    struct Shown {
        core::Rgb<Real> base, highlight;

        // The base under its highlight: the BSDF shows bare (1 - highlight) of it.
        core::Rgb<Real> bare() const {
            core::Rgb<Real> bare;
            for (int i = 0; i < 3; ++i) {
                const core::Mask<Real> isSeen = highlight[i] < Real(1);
                const Real part = base[i] / core::select(isSeen, Real(1) - highlight[i], Real(1));
                bare[i] = core::select(isSeen, core::min(part, Real(1)), Real(0));
            }
            return bare;
        }
    };
    // Where R_d is kept, both keep their hue. Phong's model, which older scenes are made for, bounds neither: the base
    // is R_d, but leaves the highlight what a varnish reflects, 0.04, if that is less than R_s; the highlight is R_s
    // or, by one factor for all channels, as much less as the channel in which least is left.
    template<class Real>
    static Shown<Real> keptOf(const core::Rgb<Real>& diffuse, const core::Rgb<Real>& specular) {
        constexpr float varnish = 0.04f;
        const Real most = Real(1) - core::min(Real(varnish), core::largestComponent<Real>(specular));
        const core::Rgb<Real> base = diffuse * (most / core::max(most, core::largestComponent<Real>(diffuse)));
        Real part(1);
        for (int i = 0; i < 3; ++i) {
            const core::Mask<Real> counts = specular[i] > Real(0);
            const Real most = (Real(1) - base[i]) / core::select(counts, specular[i], Real(1));
            part = core::min(part, core::select(counts, most, Real(1)));
        }
        return {base, specular * part};
    }
};

}  // namespace materials
