// Affine maps in single precision, for rendering; the scene database keeps its matrices in double.
#pragma once

#include "core/vec.h"

namespace core {

// Coefficient: float, or a batch with another map in each lane. Points and vectors are over Real, which is at least
// as wide.
template<class Coefficient>
struct AffineMap {
    // columns of the linear part, then the translation
    Vec3<Coefficient> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, translation{0, 0, 0};

    AffineMap() = default;
    explicit AffineMap(const glm::dmat4& m) : x(m[0]), y(m[1]), z(m[2]), translation(m[3]) {}

    template<class Real>
    Vec3<Real> vector(const Vec3<Real>& v) const {
        return {x.x * v.x + y.x * v.y + z.x * v.z, x.y * v.x + y.y * v.y + z.y * v.z,
                x.z * v.x + y.z * v.y + z.z * v.z};
    }
    template<class Real>
    Vec3<Real> point(const Vec3<Real>& p) const {
        return vector(p) + Vec3<Real>(Real(translation.x), Real(translation.y), Real(translation.z));
    }
    // The transposed linear part: a normal goes the other way of the points, by the transposed inverse.
    template<class Real>
    Vec3<Real> transposed(const Vec3<Real>& v) const {
        return {x.x * v.x + x.y * v.y + x.z * v.z, y.x * v.x + y.y * v.y + y.z * v.z,
                z.x * v.x + z.y * v.y + z.z * v.z};
    }
};

using Transform = AffineMap<float>;

}  // namespace core
