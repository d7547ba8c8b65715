// Light from so far away that it comes from one direction wherever one stands: from a disc in the sky, or from a point
// there.
#pragma once

#include "core/frame.h"
#include "core/option.h"
#include "core/warp.h"
#include "gr/direction.h"
#include "gr/lights/light_concept.h"

namespace gr {

// A surface that faces it receives the irradiance pi * colour, so that a white diffuse surface shows colour. The disc
// is as bright all over: with the half angle a its radiance is colour / sin^2 a. In lanes it is one light in each.
// Nothing but Reals, so that lanes can gather them.
template<class Real>
struct SunLightOf {
    static constexpr bool isNamed = true, isEndless = true, canBeMet = true, hasPlaces = true;

    core::Vec3<Real> along;  // which way its light goes, of any length, as it was given
    core::Rgb<Real> colour;
    Real degrees;  // across
    // What comes of them: the direction to its middle, of unit length, 1 - cos a, and 1 / sin^2 a.
    core::Vec3<Real> towards;
    Real height, radiancePerColour;

    template<class Self>
    static auto parts(Self& self) {
        return std::tie(self.along, self.colour, self.degrees, self.towards, self.height, self.radiancePerColour);
    }

    // degrees: greater than 0, at most 180.
    static SunLightOf<float> make(const glm::dvec3& along, const core::Rgbf& colour, double degrees) {
        const double half = degrees * (M_PI / 360), sine = std::sin(half), sineOfQuarter = std::sin(half / 2);
        return {core::Vec3f(along),
                colour,
                static_cast<float>(degrees),
                core::Vec3f(-directionOf(along)),
                static_cast<float>(2 * sineOfQuarter * sineOfQuarter),
                static_cast<float>(1 / (sine * sine))};
    }

    // From wherever. u: uniform in the unit square; the direction is uniform over the disc.
    LightSample<Real> sample(const core::Vec3<Real>&, const core::Vec2<Real>& u) const {
        const core::Vec3<Real> wi = core::Frame<Real>(towards).toWorld(core::squareToUniformCone(u, height));
        const Real pdf = Real(1 / (2 * core::pi)) / height;
        return {wi, wi, colour * (radiancePerColour / pdf), pdf};
    }

    Seen<Real> seen(const core::Vec3<Real>& wi) const {
        const Real pdf = core::uniformConePdfW(towards, wi, height);
        const core::Rgb<Real> radiance = colour * radiancePerColour;
        return {core::select(pdf > Real(0), radiance, core::Rgb<Real>(Real(0))), pdf};
    }

    // As AreaLight has it.
    void divideBy(const Real& times) {
        colour = core::select(times > Real(0), colour / times, core::Rgb<Real>(Real(0)));
    }
    double power() const { return M_PI * (double{colour.x} + colour.y + colour.z) / 3; }

    std::string text() const {
        return "sun {" + core::optionText(along) + "} {" + core::optionText(colour) + "} angle " +
               core::numberText(degrees);
    }
};
using SunLight = SunLightOf<float>;

// A sun without size, which nobody sees.
template<class Real>
struct ParallelLightOf {
    static constexpr bool isNamed = true, isEndless = true, canBeMet = false, hasPlaces = false;

    core::Vec3<Real> along;  // as SunLight has them
    core::Rgb<Real> colour;
    core::Vec3<Real> towards;

    template<class Self>
    static auto parts(Self& self) {
        return std::tie(self.along, self.colour, self.towards);
    }

    static ParallelLightOf<float> make(const glm::dvec3& along, const core::Rgbf& colour) {
        return {core::Vec3f(along), colour, core::Vec3f(-directionOf(along))};
    }

    LightSample<Real> sample(const core::Vec3<Real>&, const core::Vec2<Real>& = {}) const {
        return {towards, towards, colour * Real(core::pi), Real(0)};
    }

    // As AreaLight has it.
    void divideBy(const Real& times) {
        colour = core::select(times > Real(0), colour / times, core::Rgb<Real>(Real(0)));
    }
    double power() const { return M_PI * (double{colour.x} + colour.y + colour.z) / 3; }

    std::string text() const {
        return "sun {" + core::optionText(along) + "} {" + core::optionText(colour) + "} angle 0";
    }
};
using ParallelLight = ParallelLightOf<float>;

}  // namespace gr
