// The report's four ways to go on from a surface, and their mixture (section 3.6; Veach, "Robust Monte Carlo Methods
// for Light Transport Simulation", 1997, 9.2.4: the one-sample model with the balance heuristic).
#pragma once

#include "core/frame.h"
#include "core/option.h"
#include "core/warp.h"
#include "materials/bsdf.h"

namespace materials {

// The probability of each; they sum to 1.
template<class Real>
struct Methods {
    // Not Real{0}: a batch would take it for a list of all its lanes.
    Real diffuse = Real(0), reflective = Real(0), refractive = Real(0), shirley = Real(0);
};

template<class Real>
Methods<Real> methodsOf(const core::Weights& weights) {
    return {Real(weights[0]), Real(weights[1]), Real(weights[2]), Real(weights[3])};
}

template<class Real>
struct ChosenMethod {
    core::Mask<Real> diffuse, reflective, refractive, shirley;
};

// u: uniform in [0, 1). A method of probability 0 is never chosen, however the others' sum is rounded.
template<class Real>
ChosenMethod<Real> choose(const Methods<Real>& p, const Real& u) {
    const Real first = p.diffuse, second = first + p.reflective, third = second + p.refractive;
    const Real x = u * (third + p.shirley);
    const core::Mask<Real> reflective = (x >= first) & (x < second);
    const core::Mask<Real> refractive = (x >= second) & (x < third);
    return {x < first, reflective, refractive, x >= third};
}

// The mirror image of a direction.
template<class Real>
core::Vec3<Real> mirrored(const core::Vec3<Real>& w) {
    return {-w.x, -w.y, w.z};
}

// 1 - the cosine of the half angle of the cone that a mirror's direction is perturbed in.
inline float coneHeight(double degrees) {
    const float sine = core::sinCosTurns(static_cast<float>(degrees / 720)).sin;
    return 2 * sine * sine;
}

template<class Real>
core::Vec3<Real> perturbedReflection(const core::Vec3<Real>& wo, const core::Vec2<Real>& u, float height) {
    return core::Frame<Real>(mirrored(wo)).toWorld(core::squareToUniformCone(u, Real(height)));
}

// How opaque materials go on. HalfVector is Shirley's method with its pdfW and direction, for a material that has it;
// Hemisphere is what the diffuse method draws from: core::UniformHemisphere in the report, core::CosineHemisphere where
// less noise is wanted.
// What a material cannot do, refraction or half vectors, gives no sample.
template<class Real, class HalfVector, class Hemisphere>
class OpaqueMethods {
public:
    OpaqueMethods(const Methods<Real>& p, double perturbation, const HalfVector& halfVector)
        : p_(p), perturbation_(perturbation), halfVector_(halfVector) {}

    // The mean of the methods' densities, each with its probability.
    Real pdfW(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        const Real zero(0);
        Real pdf = p_.diffuse * Hemisphere::pdfW(wi);
        if (core::any(p_.reflective > zero))
            pdf += p_.reflective * core::uniformConePdfW(mirrored(wo), wi, Real(coneHeight(perturbation_)));
        if (core::any(p_.shirley > zero)) pdf += p_.shirley * halfVector_.pdfW(wo, wi);
        return core::select((wo.z > zero) & (wi.z > zero), pdf, zero);
    }

    // eval: f * |cos| as a function of wi.
    template<class Eval>
    BsdfSample<Real> sample(const core::Vec3<Real>& wo, const BsdfDraw<Real>& u, const Eval& eval) const {
        const Real zero(0);
        const ChosenMethod<Real> chosen = choose(p_, u.method);
        core::Vec3<Real> wi(zero, zero, Real(-1));
        if (core::any(chosen.diffuse)) wi = core::select(chosen.diffuse, Hemisphere::direction(u.place), wi);
        if (core::any(chosen.reflective))
            wi = core::select(chosen.reflective, perturbedReflection(wo, u.place, coneHeight(perturbation_)), wi);
        if (core::any(chosen.shirley)) wi = core::select(chosen.shirley, halfVector_.direction(wo, u.place), wi);

        const Real pdf = pdfW(wo, wi);
        const core::Mask<Real> valid = pdf > zero;
        const core::Rgb<Real> weight = eval(wi) / core::select(valid, pdf, Real(1));
        const core::Mask<Real> never = pdf < zero;
        return {wi, weight, pdf, valid, never, valid, chosen.diffuse};
    }

private:
    Methods<Real> p_;
    double perturbation_;  // degrees
    HalfVector halfVector_;
};

// For materials without half vectors.
struct NoHalfVector {
    template<class Real>
    Real pdfW(const core::Vec3<Real>&, const core::Vec3<Real>&) const {
        return Real(0);
    }
    template<class Real>
    core::Vec3<Real> direction(const core::Vec3<Real>&, const core::Vec2<Real>&) const {
        return {Real(0), Real(0), Real(-1)};
    }
};

}  // namespace materials
