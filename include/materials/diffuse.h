// A surface that scatters light evenly in all directions (Lambert).
#pragma once

#include "core/option.h"
#include "core/warp.h"
#include "materials/bsdf.h"

#include <array>

namespace materials {

struct Diffuse {
    static constexpr std::string_view typeName = "diffuse";

    core::Rgbf reflectance{0.5f};  // R_d, the part of the light that goes out again, each in [0, 1]

    static std::span<const core::OptionRow<Diffuse>> options() {
        static const std::array<core::OptionRow<Diffuse>, 1> rows{{
            {.name = "diffuse",
             .member = &Diffuse::reflectance,
             .range = core::unitInterval,
             .help = "R_d, the part of the light that is reflected"},
        }};
        return rows;
    }

    // f, per steradian. Over the hemisphere f * cos integrates to R_d, since cos integrates to pi.
    template<class Real>
    core::Rgb<Real> eval(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        const core::Mask<Real> reflects = (wo.z > Real(0)) & (wi.z > Real(0));
        const core::Rgb<Real> f = core::broadcast<Real>(reflectance * (1 / core::pi));
        return core::select(reflects, f, core::Rgb<Real>(Real(0)));
    }

    // The report draws diffuse directions uniformly over the hemisphere.
    template<class Real>
    Real pdfW(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        return core::select(wo.z > Real(0), core::uniformHemispherePdfW(wi), Real(0));
    }

    // u: uniform in the unit square.
    template<class Real>
    BsdfSample<Real> sample(const core::Vec3<Real>& wo, const core::Vec2<Real>& u) const {
        const core::Vec3<Real> wi = core::squareToUniformHemisphere(u);
        const Real pdf = core::uniformHemispherePdfW(wi);
        const core::Rgb<Real> weight = eval(wo, wi) * (wi.z / pdf);
        const core::Mask<Real> valid = (wo.z > Real(0)) & (wi.z > Real(0));
        return {wi, weight, pdf, valid, false};
    }

    // What `ambient` is multiplied with.
    core::Rgbf ambientReflectance() const { return reflectance; }
};

}  // namespace materials
