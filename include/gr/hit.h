// Where a ray met something.
#pragma once

#include "core/vec.h"

namespace gr {

template<class Real>
struct HitOf {
    Real t = Real(core::infinity);  // infinity: nowhere
    core::UInt<Real> instance = core::UInt<Real>(0);  // index into Scene::instances
    core::UInt<Real> triangle = core::UInt<Real>(0);  // for a polyhedron: which one,
    Real b1 = Real(0), b2 = Real(0);  // and the weights of its second and third vertex

    // Where two surfaces coincide the one made first is hit, in whatever order they are tested.
    bool isBefore(const HitOf& other) const {
        if (t != other.t) return t < other.t;
        return instance != other.instance ? instance < other.instance : triangle < other.triangle;
    }
};
using Hit = HitOf<float>;

}  // namespace gr
