// THE surface point: where rays met a surface, in the world. One, or one in each lane.
#pragma once

#include "core/vec.h"

namespace gr {

template<class Real>
struct SurfacePoint {
    Real t;  // along the ray; infinity: nothing was met, and the rest means nothing
    core::Vec3<Real> position;
    core::Vec3<Real> normal;  // unit length, outward
    // Unit length, on the normal's side both of the surface and of the ray. Another one only where isSmooth says so.
    core::Vec3<Real> shadingNormal;
    core::Mask<Real> isSmooth;
    // Where light must arrive to be reflected: on the round shape that a smooth mesh stands for, on the ray's side of
    // the surface; the position everywhere else.
    core::Vec3<Real> lifted;
    // Where on the surface, in which direction u grows, not of unit length, and the place in the space of the node that
    // made the object. Only where somebody asks for them.
    core::Vec2<Real> uv;
    core::Vec3<Real> tangent;
    core::Vec3<Real> inNode;
    Real step;  // how far off the surface a ray must start or end: beyond all that rounding may have moved it
    Real material, light;  // indices into those of the scene; light is -1 where nothing shines

    core::Mask<Real> isMet() const { return t < Real(core::infinity); }
    // Where a ray starts or ends that leaves the surface. side: the normal, or its negative.
    core::Vec3<Real> offset(const core::Vec3<Real>& side) const { return position + side * step; }
    // The same for light that is reflected. side: where the ray came from.
    core::Vec3<Real> liftedOffset(const core::Vec3<Real>& side) const { return lifted + side * step; }
};

}  // namespace gr
