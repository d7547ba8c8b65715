// A half line, or a piece of one.
#pragma once

#include "core/vec.h"

namespace core {

// The points origin + t * direction with 0 < t < tMax. The direction need not be of unit length, so that
// t means the same in the world and in an object's own space.
template<class Real>
struct Ray {
    Vec3<Real> origin;
    Vec3<Real> direction;
    Real tMax = Real(infinity);
};

using Rayf = Ray<float>;

}  // namespace core
