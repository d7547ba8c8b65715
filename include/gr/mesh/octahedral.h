// Unit vectors in 32 bits: the sphere is folded flat onto an octahedron, 16 bits an axis, 0.004 degrees apart at most
// (Cigolle et al., "A Survey of Efficient Representations for Independent Unit Vectors", JCGT 2014).
#pragma once

#include "core/vec.h"

#include <cstdint>

namespace gr {

using PackedNormal = std::uint32_t;
inline constexpr PackedNormal noNormal = 0x80008000;  // which no direction becomes

// normal: of any length but 0.
inline PackedNormal packNormal(const core::Vec3f& normal) {
    const float sum = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
    float u = normal.x / sum, v = normal.y / sum;
    if (normal.z < 0) {
        const float foldedU = std::copysign(1 - std::abs(v), u);
        v = std::copysign(1 - std::abs(u), v);
        u = foldedU;
    }
    const auto quantised = [](float x) {
        return static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lrint(x * 32767)));
    };
    return static_cast<PackedNormal>(quantised(u)) << 16 | quantised(v);
}

template<class Real>
core::Vec3<Real> unpackNormal(const core::UInt<Real>& packed) {
    const Real zero(0), one(1);
    const Real u = core::signedHalf(packed >> 16) / Real(32767), v = core::signedHalf(packed) / Real(32767);
    const Real z = one - core::abs(u) - core::abs(v);
    const Real foldedU = one - core::abs(v), foldedV = one - core::abs(u);
    const core::Mask<Real> isFolded = z < zero;
    return glm::normalize(core::Vec3<Real>(core::select(isFolded, core::select(u < zero, -foldedU, foldedU), u),
                                           core::select(isFolded, core::select(v < zero, -foldedV, foldedV), v), z));
}
inline core::Vec3f unpackNormal(PackedNormal packed) {
    return unpackNormal<float>(packed);
}

}  // namespace gr
