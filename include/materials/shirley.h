// Metals, plastics, varnish: Ashikhmin and Shirley, "An Anisotropic Phong BRDF Model" (Journal of Graphics Tools 5(2),
// 2000). A highlight about the mirror's direction whose width differs along u and v, over a diffuse base that fades
// where the highlight is strong.
#pragma once

#include "core/option.h"
#include "core/vec.h"
#include "materials/interior.h"
#include "materials/option_rows.h"
#include "materials/shirley_bsdf.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace materials {

struct Shirley {
    static constexpr std::string_view typeName = "shirley";
    static constexpr std::array<bool, 4> canSample{true, true, false, true};

    static constexpr double mostExponent = 1e6;

    core::Rgbf diffuse{0.5f};  // R_d, each in [0, 1]
    core::Rgbf specular{0.5f};  // R_s, each in [0, 1]
    core::Vec2f exponents{100, 100};  // nu, nv
    bool keepDiffuse = false;  // see shown()
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
    ShirleyBsdf<Real> at(const Point&) const {
        const Shown kept = keepDiffuse ? shown() : Shown{};
        core::Rgbf base = diffuse;
        // What the BSDF shows of it is base (1 - highlight).
        for (int i = 0; i < 3 && keepDiffuse; ++i)
            base[i] = kept.highlight[i] < 1 ? std::min(1.f, kept.base[i] / (1 - kept.highlight[i])) : 0.f;
        return {core::broadcast<Real>(base),
                core::broadcast<Real>(keepDiffuse ? kept.highlight : specular),
                {Real(exponents.x), Real(exponents.y)},
                sampling,
                perturbation};
    }

    bool isAnisotropic() const { return exponents.x != exponents.y; }
    std::optional<Interior> interior() const { return std::nullopt; }  // it is opaque
    core::Rgbf albedo() const { return shown().highlight + shown().base; }  // about that, seen along the normal
    core::Rgbf ambientReflectance() const { return diffuse; }

private:
    // What is seen along the normal; their sum is at most 1 in each channel.
    struct Shown {
        core::Rgbf base{0}, highlight{0};
    };
    // Where R_d is kept, both keep their hue. Phong's model, which older scenes are made for, bounds neither: the base
    // is R_d, but leaves the highlight what a varnish reflects, 0.04, if that is less than R_s; the highlight is R_s
    // or, by one factor for all channels, as much less as the channel in which least is left.
    Shown shown() const {
        if (!keepDiffuse) return {diffuse * (1.f - specular), specular};
        constexpr float varnish = 0.04f;
        const float most = 1 - std::min(varnish, core::largestComponent(specular));
        const core::Rgbf base = diffuse * (most / std::max(most, core::largestComponent(diffuse)));
        float part = 1;
        for (int i = 0; i < 3; ++i)
            if (specular[i] > 0) part = std::min(part, (1 - base[i]) / specular[i]);
        return {base, specular * part};
    }
};

}  // namespace materials
