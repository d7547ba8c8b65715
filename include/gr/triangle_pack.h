// Triangles side by side, a lane each, so that one ray is tested against a whole pack in one go.
// For baseline code only: in a file compiled for a wider instruction set PackRay would be another type.
#pragma once

#include "gr/triangle.h"

namespace gr {

// As many lanes as the least processor has: SSE2 is part of every x86-64.
using PackLanes = xsimd::batch<float>;

// A ray made ready to be tested against packs.
struct PackRay : TriangleRay<PackLanes, UniformAxes> {
    explicit PackRay(const core::Rayf& ray) : TriangleRay(TriangleRay<float>(ray)) {}
    void shortenTo(float t) { tMax = PackLanes(t); }
};

}  // namespace gr
