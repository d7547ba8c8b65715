// Noise over space: gradients that a hash puts at whole places, mixed in between (Perlin, "Improving Noise", SIGGRAPH
// 2002). The same bits on every machine and in every lane.
#pragma once

#include "core/floor.h"
#include "core/hash.h"
#include "core/vec.h"

#include <cstdint>

namespace materials {

// Of a whole place, for a seed.
template<class UInt>
UInt cellHash(const UInt& x, const UInt& y, const UInt& z, std::uint32_t seed) {
    return core::mixed(UInt(x + core::mixed(UInt(y + core::mixed(UInt(z + UInt(seed)))))));
}

template<class Real>
class LatticeNoise {
    using UInt = core::UInt<Real>;
    using Vec3 = core::Vec3<Real>;

public:
    // From -1 to 1, 0 at whole places, with steady first and second derivatives; a feature is about one unit wide.
    static Real at(const Vec3& p, std::uint32_t seed) {
        const core::Whole<Real> x(p.x), y(p.y), z(p.z);
        const Vec3 way(x.rest, y.rest, z.rest);
        const Vec3 part(fade(way.x), fade(way.y), fade(way.z));
        const UInt one(1);
        Real layers[2];
        for (std::uint32_t dz = 0; dz < 2; ++dz) {
            Real lines[2];
            for (std::uint32_t dy = 0; dy < 2; ++dy) {
                const Real from0 = corner(x.number, y.number + UInt(dy), z.number + UInt(dz), seed,
                                          way - Vec3(Real(0), offset(dy), offset(dz)));
                const Real from1 = corner(x.number + one, y.number + UInt(dy), z.number + UInt(dz), seed,
                                          way - Vec3(Real(1), offset(dy), offset(dz)));
                lines[dy] = from0 + part.x * (from1 - from0);
            }
            layers[dz] = lines[0] + part.y * (lines[1] - lines[0]);
        }
        const Real noise = layers[0] + part.z * (layers[1] - layers[0]);
        return core::min(core::max(noise, Real(-1)), Real(1));
    }

    // Octaves of it, each twice as fine and half as high as the one before: from -2 to 2.
    static Real octaves(Vec3 p, int count, std::uint32_t seed) {
        Real sum(0);
        float height = 1;
        for (int i = 0; i < count; ++i) {
            sum += at(p, seed + static_cast<std::uint32_t>(i)) * Real(height);
            p = p * Real(2);
            height *= 0.5f;
        }
        return sum;
    }

    // A place moved by such noise, another along each axis.
    static Vec3 stirred(const Vec3& p, float by, int count, std::uint32_t seed) {
        if (by == 0) return p;
        const auto along = [&](std::uint32_t axis) { return octaves(p, count, seed + (axis + 1) * 0x9e3779b9u); };
        return p + Vec3(along(0), along(1), along(2)) * Real(by);
    }

private:
    static Real offset(std::uint32_t step) { return Real(static_cast<float>(step)); }
    static Real fade(const Real& t) { return t * t * t * (t * (t * Real(6) - Real(15)) + Real(10)); }

    // The gradient at a whole place, one of the twelve from the middle of a cube to its edges, times the way from it.
    static Real corner(const UInt& x, const UInt& y, const UInt& z, std::uint32_t seed, const Vec3& way) {
        const Real number = core::toReal(UInt(cellHash<UInt>(x, y, z, seed) >> 8));
        const Real twelfth = core::wholePart(number * Real(12 * 0x1p-24f));
        const Real axis = core::wholePart(twelfth * Real(0.25f));  // the one that the gradient has no part along
        const Real signs = twelfth - axis * Real(4), second = core::wholePart(signs * Real(0.5f));
        const core::Mask<Real> isFirst = axis<Real(0.5f), isLast = axis> Real(1.5f);
        const Real u = core::select(isFirst, way.y, way.x), v = core::select(isLast, way.y, way.z);
        const Real first = signs - second * Real(2);
        return core::select(first > Real(0.5f), -u, u) + core::select(second > Real(0.5f), -v, v);
    }
};

}  // namespace materials
