// A parallelogram that shines from one side.
#pragma once

#include "core/warp.h"
#include "gr/lights/light_concept.h"
#include "gr/offset.h"

namespace gr {

// It emits the same radiance in every direction on one side and reflects nothing: what becomes of a square under an
// affine map. In lanes it is one light in each. Nothing but Reals, so that lanes can gather them.
template<class Real>
struct AreaLightOf {
    static constexpr bool isNamed = false, isEndless = false, canBeMet = true, hasPlaces = true;

    core::Vec3<Real> corner, edge1, edge2;
    core::Vec3<Real> normal;  // unit length, to the side that emits
    core::Rgb<Real> radiance;
    Real area;
    // How far rounding may put a point of it off its plane, and that of a ray that starts 1 from the origin more.
    Real error, errorPerUnit;

    template<class Self>
    static auto parts(Self& self) {
        return std::tie(self.corner, self.edge1, self.edge2, self.normal, self.radiance, self.area, self.error,
                        self.errorPerUnit);
    }

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
    // From its front.
    core::Rgb<Real> emitted() const { return radiance; }

    // A hair before the light; the end is rounded by how far away the ray starts, too.
    core::Vec3<Real> shadowEnd(const core::Vec3<Real>& start, const core::Vec3<Real>& target) const {
        const Real most = error + errorPerUnit * core::largestComponent(start);
        return target + normal * offsetBeyond<Real>(core::Vec3<Real>(most), normal);
    }

    // Makes a light of it that brings a part, for a point that asks it so many times on average; 0: never.
    void divideBy(const Real& times) {
        radiance = core::select(times > Real(0), radiance / times, core::Rgb<Real>(Real(0)));
    }

    LightBounds bounds() const {
        LightBounds bounds{{}, corner + 0.5f * (edge1 + edge2), normal, 1};
        for (const float u : {0.f, 1.f})
            for (const float v : {0.f, 1.f}) bounds.box.include(corner + edge1 * u + edge2 * v);
        return bounds;
    }
    // A surface that it faces, and that faces it, at a distance d that is large by its size, gets a mean irradiance of
    // power / (falloff.x + falloff.y d + falloff.z d^2).
    double power() const { return double{area} * (double{radiance.x} + radiance.y + radiance.z) / 3; }
    core::Vec3f falloff() const { return {0, 0, 1}; }
};
using AreaLight = AreaLightOf<float>;

}  // namespace gr
