// What every material computes, whichever it is. Directions are unit vectors in the surface's own frame and point
// away from the surface: z is the normal on the side of wo, x the surface's u axis; wo goes back along the path, wi on
// to where light comes from.
#pragma once

#include "core/vec.h"

namespace materials {

// The random numbers of a sample, uniform in [0, 1).
template<class Real>
struct BsdfDraw {
    Real method;  // which of the ways to go on is taken
    core::Vec2<Real> place;  // where in that way's own range
};

// A direction drawn by a material to go on in.
template<class Real>
struct BsdfSample {
    core::Vec3<Real> wi;  // z < 0: through the surface
    core::Rgb<Real> weight;  // f * |cos| / pdf: what the radiance from wi is multiplied with
    Real pdfW;  // per steradian, of all methods together: what the material's pdfW says of wi; 0 where isDelta
    core::Mask<Real> valid;  // false: no sample, the path goes nowhere and carries nothing
    // No density tells of wi: it is mirrored or refracted by a dielectric. Where that blurs its mirror there would be a
    // density, but it is not told.
    core::Mask<Real> isDelta;
    // Light sampling at this surface point brings what a light sends from wi.
    core::Mask<Real> isLit;
    core::Mask<Real> isDiffuse;  // drawn by the diffuse method
};

}  // namespace materials
