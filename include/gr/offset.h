// Off a surface, by what rounding may have moved a point of it.
#pragma once

#include "core/vec.h"

namespace gr {

// How far the plane across `side` must move to be beyond all of a box round a point of it: the support of that box in
// that direction. error: half the box's size along each axis.
template<class Real>
Real offsetBeyond(const core::Vec3<Real>& error, const core::Vec3<Real>& side) {
    return core::abs(side.x) * error.x + core::abs(side.y) * error.y + core::abs(side.z) * error.z;
}

}  // namespace gr
