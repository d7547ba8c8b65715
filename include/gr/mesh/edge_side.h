// On which side of a triangle's edge a line passes, so that it crosses just one of the triangles at an edge or a
// vertex.
#pragma once

#include "core/vec.h"

namespace gr {

// 1 to its left, -1 to its right, 0 where the edge is seen end-on. a, b: its ends, sheared so that the line is the
// origin. They are floats, alike for all triangles that share them, so that the products are exact. A line through an
// edge is taken to pass by a little further along x, and by far less along y: for each edge that is one and the same
// side in all triangles that share it.
inline int sideOfEdge(const core::Vec2f& a, const core::Vec2f& b) {
    const auto sign = [](double x, double y) { return x > y ? 1 : x < y ? -1 : 0; };
    if (const int side = sign(double{a.x} * b.y, double{a.y} * b.x)) return side;
    if (const int side = sign(a.y, b.y)) return side;
    return sign(b.x, a.x);
}

// The side that is the same for all three edges of a triangle, which the line then goes through, or 0.
inline int sideOfTriangle(const core::Vec2f& a, const core::Vec2f& b, const core::Vec2f& c) {
    const int side = sideOfEdge(a, b);
    return sideOfEdge(b, c) == side && sideOfEdge(c, a) == side ? side : 0;
}

}  // namespace gr
