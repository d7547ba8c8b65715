// Glass, water: smooth, clear, with light absorbed on its way inside.
#pragma once

#include "core/option.h"
#include "core/vec.h"
#include "materials/dielectric_bsdf.h"
#include "materials/interior.h"
#include "materials/option_rows.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace materials {

struct Dielectric {
    static constexpr std::string_view typeName = "dielectric";
    static constexpr std::array<bool, 4> canSample{false, true, true, false};

    core::Textured<core::Rgbf> specular{core::Rgbf(0)};  // R_s of the report's highlight, each in [0, 1]; black: none
    double index = 1.5;  // of refraction, > 0
    core::Rgbf absorption{0};  // per unit length, >= 0
    std::optional<core::Weights> sampling{};
    double perturbation = 0;  // degrees

    static std::span<const core::OptionRow<Dielectric>> options() {
        static const std::array<core::OptionRow<Dielectric>, 5> rows{{
            {.name = "specular",
             .member = &Dielectric::specular,
             .range = core::unitInterval,
             .help = "R_s of the report's highlight, a mirror image of the lights that is blurred; black: none"},
            {.name = "n",
             .member = &Dielectric::index,
             .range = {.least = 0, .most = 1e6, .leastIncluded = false},
             .help = "index of refraction"},
            {.name = "beers",
             .member = &Dielectric::absorption,
             .range = {.least = 0, .most = 1e18},
             .form = "{ar ag ab}",
             .unit = "per unit length",
             .help = "absorption a inside: e^(-a t) of the light is left after the length t"},
            samplingRow<Dielectric>("{0 F 1-F 0}, F being what the surface reflects"),
            perturbationRow<Dielectric>(core::Range{.least = 0, .most = 90}),
        }};
        return rows;
    }

    template<class Real, class Point>
    DielectricBsdf<Real> at(const Point& point) const {
        return {specular.at<Real>(point), sampling, perturbation};
    }

    bool isAnisotropic() const { return false; }
    std::optional<Interior> interior() const { return Interior{static_cast<float>(index), absorption}; }
    template<class Real, class Point>
    core::Rgb<Real> albedo(const Point&) const {
        return core::Rgb<Real>(Real(1));  // all light goes on, mirrored or refracted
    }
    template<class Real, class Point>
    core::Rgb<Real> ambientReflectance(const Point&) const {
        return core::Rgb<Real>(Real(0));
    }
};

}  // namespace materials
