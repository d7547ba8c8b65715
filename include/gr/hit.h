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
    // For another operand of a CSG object `triangle` is this where the ray comes from within that, else 0.
    static constexpr std::uint32_t leaves = 1;

    // Where two surfaces coincide the one made first is hit, in whatever order they are tested.
    bool isBefore(const HitOf& other) const {
        if (t != other.t) return t < other.t;
        return instance != other.instance ? instance < other.instance : triangle < other.triangle;
    }
};
using Hit = HitOf<float>;

// Hits of all lanes, to be looked at and replaced one by one.
template<class Real>
class HitLanes {
public:
    explicit HitLanes(const HitOf<Real>& hit) : t_(hit.t), b1_(hit.b1), b2_(hit.b2) {
        core::storeUInt<Real>(hit.instance, instance_);
        core::storeUInt<Real>(hit.triangle, triangle_);
    }

    Hit at(int lane) const { return {t_[lane], instance_[lane], triangle_[lane], b1_[lane], b2_[lane]}; }
    void set(int lane, const Hit& hit) {
        t_[lane] = hit.t;
        b1_[lane] = hit.b1;
        b2_[lane] = hit.b2;
        instance_[lane] = hit.instance;
        triangle_[lane] = hit.triangle;
    }
    HitOf<Real> hit() const {
        return {t_.real(), core::loadUInt<Real>(instance_), core::loadUInt<Real>(triangle_), b1_.real(), b2_.real()};
    }

private:
    core::LaneArray<Real> t_, b1_, b2_;
    std::uint32_t instance_[core::laneCount<Real>], triangle_[core::laneCount<Real>];
};

}  // namespace gr
