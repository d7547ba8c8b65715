// What every material computes, whichever it is. Directions are unit vectors in the surface's own frame and point
// away from the surface: z is the normal on the side of wo, wo goes back along the path, wi on to where light comes
// from.
#pragma once

#include "core/vec.h"

namespace materials {

// A direction drawn by a material to go on in.
template<class Real>
struct BsdfSample {
    core::Vec3<Real> wi;
    core::Rgb<Real> weight;  // f * |cos| / pdf: what the radiance from wi is multiplied with
    Real pdfW;  // per steradian; 0 where isDelta
    core::Mask<Real> valid;  // false: no sample, the path goes nowhere and carries nothing
    bool isDelta;  // the direction has no density (mirror, refraction): light sampling cannot draw it
};

}  // namespace materials
