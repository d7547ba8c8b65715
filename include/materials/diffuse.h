// A surface that scatters light evenly in all directions (Lambert).
#pragma once

#include "core/option.h"
#include "core/vec.h"
#include "core/warp.h"
#include "materials/bsdf.h"
#include "materials/interior.h"
#include "materials/methods.h"
#include "materials/option_rows.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace materials {

template<class Real>
struct DiffuseBsdf {
    core::Rgb<Real> reflectance;  // R_d
    std::optional<core::Weights> sampling;
    double perturbation;  // degrees

    // f * |cos|, f per steradian. Over the hemisphere it integrates to R_d, since cos integrates to pi.
    core::Rgb<Real> eval(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        const core::Mask<Real> reflects = (wo.z > Real(0)) & (wi.z > Real(0));
        const core::Rgb<Real> f = reflectance * Real(1 / core::pi);
        return core::select(reflects, f * wi.z, core::Rgb<Real>(Real(0)));
    }

    template<class Hemisphere = core::UniformHemisphere>
    Real pdfW(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        return methods<Hemisphere>().pdfW(wo, wi);
    }

    template<class Hemisphere = core::UniformHemisphere>
    BsdfSample<Real> sample(const core::Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real&) const {
        return methods<Hemisphere>().sample(wo, u, [&](const core::Vec3<Real>& wi) { return eval(wo, wi); });
    }

private:
    template<class Hemisphere>
    OpaqueMethods<Real, NoHalfVector, Hemisphere> methods() const {
        return {sampling ? methodsOf<Real>(*sampling) : Methods<Real>{.diffuse = Real(1)}, perturbation, {}};
    }
};

struct Diffuse {
    static constexpr std::string_view typeName = "diffuse";
    static constexpr std::array<bool, 4> canSample{true, true, false, false};

    core::Textured<core::Rgbf> reflectance{
        core::Rgbf(0.5f)};  // R_d, the part of the light that goes out again, each in [0, 1]
    std::optional<core::Weights> sampling{};
    double perturbation = 5;  // degrees

    static std::span<const core::OptionRow<Diffuse>> options() {
        static const std::array<core::OptionRow<Diffuse>, 3> rows{{
            {.name = "diffuse",
             .member = &Diffuse::reflectance,
             .range = core::unitInterval,
             .help = "R_d, the part of the light that is reflected"},
            samplingRow<Diffuse>("{1 0 0 0}"),
            perturbationRow<Diffuse>(core::Range{.least = 0, .most = 90, .leastIncluded = false}),
        }};
        return rows;
    }

    template<class Real, class Point>
    DiffuseBsdf<Real> at(const Point& point) const {
        return {reflectance.at<Real>(point), sampling, perturbation};
    }

    bool isAnisotropic() const { return false; }
    std::optional<Interior> interior() const { return std::nullopt; }  // it is opaque
    template<class Real, class Point>
    core::Rgb<Real> albedo(const Point& point) const {
        return reflectance.at<Real>(point);
    }
    template<class Real, class Point>
    core::Rgb<Real> ambientReflectance(const Point& point) const {
        return reflectance.at<Real>(point);
    }
};

}  // namespace materials
