// Directions and random numbers for the tests of the materials.
#pragma once

#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "core/frame.h"
#include "core/warp.h"
#include "materials/bsdf.h"
#include "support/test_random.h"

namespace materials {

// Where the path comes from: along the normal, and flatter and flatter, on different sides.
inline std::array<core::Vec3f, 4> outgoingDirections() {
    std::array<core::Vec3f, 4> directions;
    const double cosines[] = {1, 0.7, 0.1, 0.001};
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double sine = std::sqrt(1 - cosines[i] * cosines[i]);
        const double phi = 1.1 * static_cast<double>(i);
        directions[i] = {sine * std::cos(phi), sine * std::sin(phi), cosines[i]};
    }
    return directions;
}

// Uniform in [0, 1), as a renderer draws them: never 1 by rounding.
inline float nextFloat(support::TestRandom& random) {
    return static_cast<float>(random.nextBits() >> 40) * 0x1p-24f;
}
inline core::Vec2f nextPoint(support::TestRandom& random) {
    const float u = nextFloat(random);
    const float v = nextFloat(random);
    return {u, v};
}
inline BsdfDraw<float> nextDraw(support::TestRandom& random) {
    const float method = nextFloat(random);
    return {method, nextPoint(random)};
}

// Uniform over the upper hemisphere.
inline core::Vec3f nextDirection(support::TestRandom& random) {
    return core::squareToUniformHemisphere(nextPoint(random));
}

// Within some widths (in radians) of a direction, most of them within one.
inline core::Vec3f nextDirectionNear(const core::Vec3f& centre, double width, support::TestRandom& random) {
    const double turn = 6.2831853 * random.next(), distance = 2 * width * random.next();
    const core::Vec3f local(distance * std::cos(turn), distance * std::sin(turn), 1);
    return core::Frame<float>(centre).toWorld(glm::normalize(local));
}

inline std::string text(const core::Vec3f& v) {
    std::ostringstream text;
    text << "(" << v.x << " " << v.y << " " << v.z << ")";
    return text.str();
}

}  // namespace materials
