// A point that shines into a cone.
#pragma once

#include "gr/direction.h"
#include "gr/lights/point_light.h"

#include <algorithm>

namespace gr {

// As bright along its axis as a point light, and dark outside a cone about it. From there towards the axis it becomes
// brighter over a part of the cone, the softness: with the cosine c of the angle to the axis and that of the cone's
// half angle a, s(t) = t^2 (3 - 2t) of t = (c - cos a) / (softness (1 - cos a)), which is Blender's way. In lanes it is
// one light in each. Nothing but Reals, so that lanes can gather them.
template<class Real>
struct SpotLightOf {
    static constexpr bool isNamed = true, isEndless = false, canBeMet = false, hasPlaces = false;

    PointLightOf<Real> point;
    core::Vec3<Real> along;  // of any length, as it was given
    Real degrees, softness;  // the whole angle of the cone, 0 to 180, and the part of it from 0 to 1
    core::Vec3<Real> axis;  // of unit length
    Real height, softHeight;  // 1 - cos a, and softness times that

    template<class Self>
    static auto parts(Self& self) {
        return std::tuple_cat(PointLightOf<Real>::parts(self.point), std::tie(self.along, self.degrees, self.softness,
                                                                              self.axis, self.height, self.softHeight));
    }

    static SpotLightOf<float> make(const PointLightOf<float>& point, const glm::dvec3& along, double degrees,
                                   double softness) {
        const double sineOfQuarter = std::sin(degrees * (M_PI / 720)), height = 2 * sineOfQuarter * sineOfQuarter;
        return {point,
                core::Vec3f(along),
                static_cast<float>(degrees),
                static_cast<float>(softness),
                core::Vec3f(directionOf(along)),
                static_cast<float>(height),
                static_cast<float>(height * softness)};
    }

    LightSample<Real> sample(const core::Vec3<Real>& from, const core::Vec2<Real>& = {}) const {
        LightSample<Real> sample = point.sample(from);
        // The square of the chord between two directions is 2 (1 - cos), to all digits in narrow cones, too.
        const core::Vec3<Real> chord = sample.wi + axis;
        const Real inside = height - Real(0.5f) * glm::dot(chord, chord);
        const Real t = core::min(inside / core::max(softHeight, Real(0x1p-60f)), Real(1));
        const core::Rgb<Real> weight = sample.weight * (t * t * (Real(3) - Real(2) * t));
        sample.weight = core::select(inside > Real(0), weight, core::Rgb<Real>(Real(0)));
        return sample;
    }

    core::Vec3<Real> shadowEnd(const core::Vec3<Real>& start, const core::Vec3<Real>& target) const {
        return point.shadowEnd(start, target);
    }
    void divideBy(const Real& times) { point.divideBy(times); }

    // Beyond the cone nothing comes, which is less than the tree counts on.
    LightBounds bounds() const { return {{point.position, point.position}, point.position, axis, 1 - height}; }
    // As AreaLight has it; along the axis, at every distance.
    double power() const { return point.power(); }
    core::Vec3f falloff() const { return point.falloff(); }

    void moveBy(const core::Vec3<Real>& way) { point.moveBy(way); }
    std::string text() const {
        return "spot" + point.text().substr(std::string("point").size()) + " towards {" + core::optionText(along) +
               "} angle " + core::numberText(degrees) + " softness " + core::numberText(softness);
    }
};
using SpotLight = SpotLightOf<float>;

}  // namespace gr
