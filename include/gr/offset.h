// Off a surface, by what rounding may have moved a point of it.
#pragma once

#include "core/vec.h"

namespace gr {

// The plane moves by the support of the error's cube in the direction of `side`.
template<class Real>
core::Vec3<Real> offsetFrom(const core::Vec3<Real>& position, const core::Vec3<Real>& side, const Real& error) {
    return position + side * (error * (core::abs(side.x) + core::abs(side.y) + core::abs(side.z)));
}

}  // namespace gr
