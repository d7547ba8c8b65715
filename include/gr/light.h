// THE lights that a surface point asks for light. To add one: write its struct here, with sample over Real.
#pragma once

#include "core/warp.h"

namespace gr {

// Light that may arrive at a surface point from a place drawn on a light.
template<class Real>
struct LightSample {
    core::Vec3<Real> target;  // the place on the light, where the shadow ray ends
    core::Vec3<Real> wi;  // unit direction to it
    core::Rgb<Real> weight;  // radiance / pdfW: times f * cos it estimates the radiance reflected; black: no light
    Real pdfW;  // per steradian as seen from the surface point; 0 for a point light, which has none
};

// A parallelogram that emits the same radiance in every direction on one side and reflects nothing: what becomes of a
// square under an affine map. In lanes it is one light in each. Nothing but Reals, so that lanes can gather them.
template<class Real>
struct AreaLightOf {
    core::Vec3<Real> corner, edge1, edge2;
    core::Vec3<Real> normal;  // unit length, to the side that emits
    core::Rgb<Real> radiance;
    Real area;
    // How far rounding may put a point of it off its plane, and that of a ray that starts 1 from the origin more.
    Real error, errorPerUnit;

    // from: the surface point. u: uniform in the unit square; the place is uniform on the light.
    LightSample<Real> sample(const core::Vec3<Real>& from, const core::Vec2<Real>& u) const {
        const core::Vec3<Real> target = corner + edge1 * u.x + edge2 * u.y;
        const core::Vec3<Real> toLight = target - from;
        const Real distanceSquared = glm::dot(toLight, toLight);
        const core::Vec3<Real> wi = toLight / core::sqrt(distanceSquared);

        // dA = dw * distance^2 / cos: the density 1 / area becomes one over solid angle. The back is dark.
        const Real cosine = -glm::dot(wi, normal);
        const core::Mask<Real> lit = (cosine > Real(0)) & (distanceSquared > Real(0));
        const Real pdf = core::pdfAtoW(Real(1) / area, distanceSquared, cosine);
        const core::Rgb<Real> weight = radiance / pdf;
        return {target, wi, core::select(lit, weight, core::Rgb<Real>(Real(0))), core::select(lit, pdf, Real(0))};
    }

    // The density of sample() for a ray of direction wi, of unit length, that meets the light's front after `distance`.
    Real pdfW(const core::Vec3<Real>& wi, const Real& distance) const {
        return core::pdfAtoW(Real(1) / area, distance * distance, -glm::dot(wi, normal));
    }
};
using AreaLight = AreaLightOf<float>;

// The light of that index, for each lane.
template<class Real>
AreaLightOf<Real> gathered(const AreaLight* lights, const core::UInt<Real>& index) {
    const core::GatheredRow<Real, AreaLight> row(lights, index);
    return {row.vector(offsetof(AreaLight, corner)),   row.vector(offsetof(AreaLight, edge1)),
            row.vector(offsetof(AreaLight, edge2)),    row.vector(offsetof(AreaLight, normal)),
            row.vector(offsetof(AreaLight, radiance)), row.number(offsetof(AreaLight, area)),
            row.number(offsetof(AreaLight, error)),    row.number(offsetof(AreaLight, errorPerUnit))};
}
// The same light in all lanes.
template<class Real>
AreaLightOf<Real> broadcast(const AreaLight& light) {
    const auto lanes = [](const core::Vec3f& v) { return core::broadcast<Real>(v); };
    return {lanes(light.corner),   lanes(light.edge1), lanes(light.edge2), lanes(light.normal),
            lanes(light.radiance), Real(light.area),   Real(light.error),  Real(light.errorPerUnit)};
}

// The older point light. A surface that faces it at distance d receives the irradiance
// pi * intensity / (c0 + c1 d + c2 d^2), so that a white diffuse surface shows intensity / (...).
struct PointLight {
    core::Vec3f position;
    core::Rgbf intensity;
    core::Vec3f attenuation;  // c0, c1, c2: not negative, not all 0

    template<class Real>
    LightSample<Real> sample(const core::Vec3<Real>& from) const {
        const core::Vec3<Real> target = core::broadcast<Real>(position);
        const core::Vec3<Real> toLight = target - from;
        const Real distance = core::sqrt(glm::dot(toLight, toLight));
        const Real falloff = Real(attenuation.x) + distance * (Real(attenuation.y) + distance * Real(attenuation.z));
        const core::Mask<Real> lit = distance > Real(0);
        const core::Rgb<Real> weight = core::broadcast<Real>(intensity * core::pi) / falloff;
        return {target, toLight / distance, core::select(lit, weight, core::Rgb<Real>(Real(0))), Real(0)};
    }
};

}  // namespace gr
