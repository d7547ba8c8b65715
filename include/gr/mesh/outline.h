// A polygon as seen from one side.
#pragma once

#include "core/vec.h"

#include <vector>

namespace gr {

using Outline = std::vector<glm::dvec2>;  // counter-clockwise

// Twice the area of a, b, c: positive when they turn left.
inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const glm::dvec2 u = b - a, v = c - a;
    return u.x * v.y - u.y * v.x;
}

// Up to so many corners, what takes time quadratic in them is quicker than what does not.
inline constexpr std::size_t fewCorners = 32;

// Whether two of its edges cross; to touch is not to cross. Takes n log n of n corners.
bool crossesItself(const Outline& outline);

// Cuts an outline that does not cross itself into triangles, which are numbers of its corners, and appends them: of a
// convex one a fan. False when it cannot be cut into triangles that all turn left. onLine: what remains, corners in one
// line; or none.
//
// Of n corners at most 3n are looked at, and each look takes log n and as much as there are cells of corners along the
// sides of one triangle (CornerTree): sqrt(n) where corners are spread over an area, log n along a curve.
bool clipEars(const Outline& outline, std::vector<glm::ivec3>& triangles, std::vector<int>& onLine);

}  // namespace gr
