// The older scenes' light: a point that shines to all sides.
#pragma once

#include "core/option.h"
#include "gr/lights/light_concept.h"

namespace gr {

// A surface that faces it at distance d receives the irradiance pi * intensity / (c0 + c1 d + c2 d^2), so that a white
// diffuse surface shows intensity / (...). In lanes it is one light in each. Nothing but Reals, so that lanes can
// gather them.
template<class Real>
struct PointLightOf {
    static constexpr bool isNamed = true, isEndless = false, canBeMet = false, hasPlaces = false;

    core::Vec3<Real> position;
    core::Rgb<Real> intensity;
    core::Vec3<Real> attenuation;  // c0, c1, c2: not negative, not all 0

    template<class Self>
    static auto parts(Self& self) {
        return std::tie(self.position, self.intensity, self.attenuation);
    }

    LightSample<Real> sample(const core::Vec3<Real>& from, const core::Vec2<Real>& = {}) const {
        const core::Vec3<Real> toLight = position - from;
        const Real distance = core::sqrt(glm::dot(toLight, toLight));
        const Real falloff = attenuation.x + distance * (attenuation.y + distance * attenuation.z);
        const core::Mask<Real> lit = distance > Real(0);
        const core::Rgb<Real> weight = intensity * Real(core::pi) / falloff;
        return {position, toLight / distance, core::select(lit, weight, core::Rgb<Real>(Real(0))), Real(0)};
    }

    core::Vec3<Real> shadowEnd(const core::Vec3<Real>&, const core::Vec3<Real>& target) const { return target; }

    // As AreaLight has it.
    void divideBy(const Real& times) {
        intensity = core::select(times > Real(0), intensity / times, core::Rgb<Real>(Real(0)));
    }

    LightBounds bounds() const { return {{position, position}, position, {0, 1, 0}, -1}; }
    // As AreaLight has it, at every distance.
    double power() const { return double{core::pi} * (double{intensity.x} + intensity.y + intensity.z) / 3; }
    core::Vec3f falloff() const { return attenuation; }

    void moveBy(const core::Vec3<Real>& way) { position += way; }
    std::string text() const {
        const auto list = [](const core::Vec3f& v) { return " {" + core::optionText(v) + "}"; };
        return "point light" + list(position) + list(intensity) + list(attenuation);
    }
};
using PointLight = PointLightOf<float>;

}  // namespace gr
