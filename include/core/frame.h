// An orthonormal frame round a normal: local z is the normal.
#pragma once

#include "core/vec.h"

namespace core {

template<class Real>
struct Frame {
    Vec3<Real> x, y, z;

    // normal: of unit length. Duff et al., "Building an Orthonormal Basis, Revisited" (JCGT 2017): no branch, and
    // no direction in which the frame degenerates.
    explicit Frame(const Vec3<Real>& normal) : z(normal) {
        // Not copysign: lanes may differ in the sign of a zero.
        const Real sign = select(normal.z < Real(0), Real(-1), Real(1));
        const Real a = Real(-1) / (sign + normal.z);
        const Real b = normal.x * normal.y * a;
        x = {Real(1) + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
        y = {b, sign + normal.y * normal.y * a, -normal.y};
    }

    // With the x axis along the tangent, which need be neither of unit length nor quite across the normal.
    Frame(const Vec3<Real>& normal, const Vec3<Real>& tangent)
        : x(glm::normalize(tangent - normal * glm::dot(normal, tangent))), y(glm::cross(normal, x)), z(normal) {}

    Vec3<Real> toLocal(const Vec3<Real>& world) const {
        return {glm::dot(world, x), glm::dot(world, y), glm::dot(world, z)};
    }
    Vec3<Real> toWorld(const Vec3<Real>& local) const { return x * local.x + y * local.y + z * local.z; }
};

}  // namespace core
