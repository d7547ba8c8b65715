// Surfaces where the rays of many paths met them, in the world.
#pragma once

#include "core/vec.h"

namespace gr {

template<class Real>
struct SurfacePointOf {
    Real t;  // infinity: nothing was met, and the rest means nothing
    core::Vec3<Real> position;
    core::Vec3<Real> normal;  // unit length, outward
    core::Vec3<Real> shadingNormal;
    core::Vec3<Real> tangent;  // the u axis of materials that have one; only where it is asked for
    Real error;  // see Instance
    Real material, light;  // indices; light is -1 where nothing shines
    core::Mask<Real> isSmooth;

    core::Mask<Real> isMet() const { return t < Real(core::infinity); }
};

}  // namespace gr
