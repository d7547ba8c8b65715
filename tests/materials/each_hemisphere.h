// Materials with either way to draw the directions of the diffuse method.
#pragma once

#include "materials/parameter_sets.h"

#include <string>

namespace materials {

// By the cosine, as the path integrator does it; a BSDF itself draws them uniformly, as the report.
template<class Bsdf, class Real>
struct BsdfByTheCosine : Bsdf {
    Real pdfW(const core::Vec3<Real>& wo, const core::Vec3<Real>& wi) const {
        return Bsdf::template pdfW<core::CosineHemisphere>(wo, wi);
    }
    BsdfSample<Real> sample(const core::Vec3<Real>& wo, const BsdfDraw<Real>& u, const Real& indexBeyond) const {
        return Bsdf::template sample<core::CosineHemisphere>(wo, u, indexBeyond);
    }
};
template<class M>
struct ByTheCosine : M {
    template<class Real, class Point>
    BsdfByTheCosine<BsdfOf<M, Real>, Real> at(const Point& point) const {
        return {M::template at<Real>(point)};
    }
};

// Calls test(material, name) for all parameter sets of a material, and by the cosine for those that make a difference.
template<class M, class Test>
void forEachSetAndHemisphere(const Test& test) {
    int i = 0;
    for (const M& material : parameterSets<M>()) {
        const std::string name = "set " + std::to_string(i++);
        test(material, name);
        if (!M::canSample[0] || (material.sampling && (*material.sampling)[0] == 0)) continue;
        test(ByTheCosine<M>{material}, name + " by the cosine");
    }
}

}  // namespace materials
