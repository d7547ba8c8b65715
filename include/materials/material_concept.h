// The BSDF that a material makes at a surface point.
#pragma once

#include <utility>

namespace materials {

// It stands for any surface point, gr::SurfacePoint too, which this module may not name.
struct SomePoint {};

template<class Material, class Real>
using BsdfOf = decltype(std::declval<const Material&>().template at<Real>(SomePoint{}));

}  // namespace materials
