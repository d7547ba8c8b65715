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

    template<class Real, class Point>
    ShirleyBsdf<Real> at(const Point&) const {
        return {core::broadcast<Real>(diffuse),
                core::broadcast<Real>(specular),
                {Real(exponents.x), Real(exponents.y)},
                sampling,
                perturbation};
    }

    bool isAnisotropic() const { return exponents.x != exponents.y; }
    std::optional<Interior> interior() const { return std::nullopt; }  // it is opaque
    core::Rgbf albedo() const { return specular + diffuse * (1.f - specular); }  // about that, seen along the normal
    core::Rgbf ambientReflectance() const { return diffuse; }
};

}  // namespace materials
