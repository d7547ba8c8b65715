// What a surface point may hope for from lights that lie near each other.
#pragma once

#include "core/vec.h"

namespace render {

// Nothing but Reals, so that lanes can gather them.
template<class Real>
struct LightNode {
    core::Vec3<Real> centre;
    Real radius;  // of a ball that holds them
    core::Vec3<Real> axis;
    Real cosine, sine;  // of the half angle of a cone about the axis that holds the normals of all their fronts
    Real power;  // the sum of theirs, over that of all lights
    core::Vec3<Real> falloff;  // by what their light fades, on average: see importance()
    Real least;  // the distance from which they shine on what is among them

    // About the irradiance that they send to a point that faces them, and 0 only where none of them shines. Each sends
    // its power * cosine / (falloff.x + falloff.y * distance + falloff.z * distance^2). The cosine is at most that of
    // the angle at the centre, between axis and way, less the cone's half angle, less half of the angle under which the
    // ball is seen.
    Real importance(const core::Vec3<Real>& at) const {
        const core::Vec3<Real> way = at - centre;
        const Real distanceSquared = glm::dot(way, way);
        const Real distance = core::sqrt(distanceSquared);
        const core::Mask<Real> isInside = !(distance > radius);
        const Real ballSine = core::select(isInside, Real(1), radius / distance);
        const Real ballCosine = core::sqrt(core::max(Real(1) - ballSine * ballSine, Real(0)));
        const Real slackCosine = cosine * ballCosine - sine * ballSine;
        const Real slackSine = sine * ballCosine + cosine * ballSine;
        const Real angleCosine = core::select(isInside, Real(1), glm::dot(axis, way) / distance);
        const Real angleSine = core::sqrt(core::max(Real(1) - angleCosine * angleCosine, Real(0)));
        // A negative sine: the slack is more than half a turn.
        const core::Mask<Real> isWithin = isInside | (slackSine < Real(0)) | (angleCosine >= slackCosine);
        const Real bound = core::select(isWithin, Real(1), angleCosine * slackCosine + angleSine * slackSine);
        const Real fading =
            falloff.x + falloff.y * core::max(distance, least) + falloff.z * core::max(distanceSquared, least * least);
        // What is dark stays so on the light itself; and two of them, as a sum, are finite.
        const Real most = power * core::max(bound, Real(0)) / core::max(fading, Real(0x1p-126f));
        return core::min(most, Real(0x1p100f));
    }
};

}  // namespace render
