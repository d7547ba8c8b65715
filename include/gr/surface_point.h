// THE surface point: where rays met a surface, in the world. One, or one in each lane.
#pragma once

#include "core/vec.h"
#include "gr/offset.h"

namespace gr {

template<class Real>
struct SurfacePoint {
    Real t;  // along the ray; infinity: nothing was met, and the rest means nothing
    core::Vec3<Real> position;
    core::Vec3<Real> normal;  // unit length, outward
    // Unit length, on the normal's side both of the surface and of the ray. Another one only where isSmooth says so.
    core::Vec3<Real> shadingNormal;
    core::Mask<Real> isSmooth;
    // Where on the surface, and in which direction u grows, not of unit length. Only where somebody asks for them.
    core::Vec2<Real> uv;
    core::Vec3<Real> tangent;
    Real error;  // see Instance
    Real material, light;  // indices into those of the scene; light is -1 where nothing shines

    core::Mask<Real> isMet() const { return t < Real(core::infinity); }
    // Where a ray starts or ends that leaves the surface on the side of the normal (or, negated, on the other): so far
    // off it that it cannot meet it again, whatever was rounded.
    core::Vec3<Real> offset(const core::Vec3<Real>& side) const { return offsetFrom(position, side, error); }
};

}  // namespace gr
