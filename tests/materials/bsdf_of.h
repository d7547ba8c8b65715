// What a material is at a surface point. The tests' points know nothing of where they are.
#pragma once

#include "materials/material_concept.h"

namespace materials {

template<class Real = float, class M>
auto bsdfOf(const M& material) {
    return material.template at<Real>(SomePoint{});
}

}  // namespace materials
