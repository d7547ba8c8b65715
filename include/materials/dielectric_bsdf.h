// How a smooth surface between two clear media mirrors and refracts light.
#pragma once

#include "core/option.h"
#include "core/vec.h"
#include "core/warp.h"
#include "materials/bsdf.h"
#include "materials/methods.h"

#include <optional>

namespace materials {

// Fresnel's equations for unpolarised light: the part that a smooth surface reflects. cosine, transmitted: of the
// angles to the normal on this side and beyond; index: of refraction, beyond over this side. (Born and Wolf, 1.5.2)
template<class Real>
Real fresnelReflectance(const Real& cosine, const Real& transmitted, const Real& index) {
    // ((c - n t) / (c + n t))^2 across the plane of incidence and ((n c - t) / (n c + t))^2 in it, over one
    // denominator.
    const Real n = core::min(index, Real(1e9f));  // larger ones reflect all, too, and would overflow
    const Real acrossSum = cosine + n * transmitted, alongSum = n * cosine + transmitted;
    const Real across = (cosine - n * transmitted) * alongSum, along = (n * cosine - transmitted) * acrossSum;
    const Real below = acrossSum * alongSum;
    const Real below2 =
        core::max(below * below, Real(1e-37f));  // equal indices at the flattest angles: nothing reflects
    return (across * across + along * along) / below2 * Real(0.5f);
}

template<class Real>
struct DielectricBsdf {
    core::Rgb<Real> specular;  // R_s of the report's highlight
    std::optional<core::Weights> sampling;
    double perturbation;  // degrees

    // f * |cos|: the report's highlight, R_s (r.k)^10. r is the mirror's direction of wi. Neither reciprocal nor
    // bounded by the light that arrives.
    core::Rgb<Real> eval(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        const core::Mask<Real> reflects = (wo.z > Real(0)) & (wi.z > Real(0));
        const Real cosine = core::max(Real(0), glm::dot(mirrored(wi), wo));
        const Real cosine2 = cosine * cosine, cosine4 = cosine2 * cosine2;
        return core::select(reflects, specular * (cosine4 * cosine4 * cosine2), core::Rgb<Real>(Real(0)));
    }

    template<class Hemisphere = core::UniformHemisphere>
    Real pdfW(const core::Vec3<Real>&, const core::Vec3<Real>&) const {
        return Real(0);
    }

    // indexBeyond: of refraction, beyond the surface over this side of it.
    template<class Hemisphere = core::UniformHemisphere>
    BsdfSample<Real> sample(const core::Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& indexBeyond) const {
        const Real zero(0), one(1);
        // Snell's law. The cosine beyond comes from the sine; flatter, where that has lost its digits, from the cosine.
        const Real inverse = one / indexBeyond;
        const core::Vec3<Real> w = wo * inverse;
        const Real flatCosine2 = ((indexBeyond - one) * inverse) * ((indexBeyond + one) * inverse) + w.z * w.z;
        const Real transmitted2 = core::select(wo.z < Real(0.7f), flatCosine2, one - (w.x * w.x + w.y * w.y));
        const core::Mask<Real> isTotal = !(transmitted2 > zero);
        const Real transmitted = core::sqrt(core::max(transmitted2, zero));
        const core::Vec3<Real> refracted(-w.x, -w.y, -transmitted);
        const Real reflectance = core::select(isTotal, one, fresnelReflectance(wo.z, transmitted, indexBeyond));

        const Methods<Real> p = sampling ? methodsOf<Real>(*sampling)
                                         : Methods<Real>{.reflective = reflectance, .refractive = one - reflectance};
        const ChosenMethod<Real> chosen = choose(p, u.method);
        const core::Vec3<Real> reflected =
            perturbation > 0 ? perturbedReflection(wo, u.place, coneHeight(perturbation)) : mirrored(wo);
        // Radiance grows with the square of the index that it enters: the same light fills a narrower cone.
        Real part = core::select(chosen.reflective, one, inverse * inverse);
        if (sampling)
            part *= core::select(chosen.reflective, reflectance, one - reflectance) /
                    core::select(chosen.reflective, p.reflective, p.refractive);
        const core::Mask<Real> reflects = chosen.reflective & (reflected.z > zero);
        const core::Mask<Real> refracts = chosen.refractive & !isTotal;
        const core::Mask<Real> valid = (wo.z > zero) & (reflects | refracts);
        const core::Mask<Real> isDiffuse = one < zero;
        // The highlight is what light sampling brings of a lamp's mirror image.
        const core::Mask<Real> hasHighlight = (specular.x > zero) | (specular.y > zero) | (specular.z > zero);
        const core::Mask<Real> isLit = reflects & hasHighlight;
        return {
            core::select(reflects, reflected, refracted), core::Rgb<Real>(part), zero, valid, valid, isLit, isDiffuse};
    }
};

}  // namespace materials
