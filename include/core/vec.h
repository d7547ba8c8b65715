// Vectors and colours over Real.
#pragma once

#include "core/lanes.h"

#include <cstddef>
#include <glm/glm.hpp>

namespace core {

template<class Real>
using Vec2 = glm::vec<2, Real>;
template<class Real>
using Vec3 = glm::vec<3, Real>;
// Linear red, green and blue: a radiance, or a factor without unit.
template<class Real>
using Rgb = glm::vec<3, Real>;

using Vec2f = Vec2<float>;
using Vec3f = Vec3<float>;
using Rgbf = Rgb<float>;

inline constexpr float pi = 3.14159265358979323846f;
inline constexpr float infinity = std::numeric_limits<float>::infinity();

template<class Real>
Vec3<Real> select(const Mask<Real>& mask, const Vec3<Real>& yes, const Vec3<Real>& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

// The same vector in every lane.
template<class Real>
Vec3<Real> broadcast(const Vec3f& v) {
    return {Real(v.x), Real(v.y), Real(v.z)};
}

// A row of a table for each lane. Rows hold nothing but floats; offset: of a number in its row, in bytes, as offsetof
// tells it.
template<class Real, class Row>
class GatheredRow {
public:
    // Every lane's index must be within the table, whether it counts or not.
    GatheredRow(const Row* table, const UInt<Real>& index)
        : table_(reinterpret_cast<const float*>(table)), place_(index * UInt<Real>(sizeof(Row) / sizeof(float))) {
        static_assert(sizeof(Row) % sizeof(float) == 0);
    }
    Real number(std::size_t offset) const { return gather(table_ + offset / sizeof(float), place_); }
    Vec3<Real> vector(std::size_t offset) const {
        return {number(offset), number(offset + sizeof(float)), number(offset + 2 * sizeof(float))};
    }

private:
    const float* table_;
    UInt<Real> place_;
};

template<class Real>
Real largestComponent(const Vec3<Real>& v) {
    return max(max(Real(abs(v.x)), Real(abs(v.y))), Real(abs(v.z)));
}
inline float largestComponent(const Vec3f& v) {
    return largestComponent<float>(v);
}

inline bool isFinite(const Vec3f& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace core
