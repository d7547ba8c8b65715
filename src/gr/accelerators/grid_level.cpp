#include "gr/accelerators/grid_level.h"

#include <cmath>
#include <functional>

namespace gr {
namespace {

// The side of the cubes that cut a box into so many cells, one layer being the least along each axis.
double edgeOf(const glm::dvec3& size, double cells) {
    std::array<double, 3> sides{size.x, size.y, size.z};
    std::sort(sides.begin(), sides.end(), std::greater<>());
    double edge = std::cbrt(sides[0] * sides[1] * sides[2] / cells);
    if (sides[2] < edge) edge = std::sqrt(sides[0] * sides[1] / cells);
    if (sides[1] < edge) edge = sides[0] / cells;
    return edge;
}

}  // namespace

GridLevel::GridLevel(const core::Bounds& box, double cells, float errorPerUnit, const core::Vec3f& shape)
    : low(box.low) {
    // A walk counts in cells: it rounds where the ray enters (3 times), its slope (3), and the sum of both (2); a
    // coordinate may be twice the reach from the low side.
    rounding = 0x1p-20f * box.reach();
    const float thinnest = core::max(0x1p-16f * core::largestComponent(box.size()), 8 * rounding);
    const glm::dvec3 size = glm::max(box.size(), core::Vec3f(core::max(thinnest, 1e-30f)));
    const glm::dvec3 sides = edgeOf(size / glm::dvec3(shape), cells) * glm::dvec3(shape);
    core::Bounds whole{low, low};
    for (int axis = 0; axis < 3; ++axis) {
        count[axis] = static_cast<int>(std::clamp(std::round(size[axis] / sides[axis]), 1.0, 4096.0));
        cell[axis] = static_cast<float>(size[axis] / count[axis]);
        inverseCell[axis] = 1 / cell[axis];
        whole.high[axis] = boundary(count[axis], axis);
    }
    whole = whole.widened(rounding);
    reach = whole.widened(errorPerUnit * whole.reach());
    stride = {1, bricks(0), bricks(0) * bricks(1)};
}

core::Bounds GridLevel::boundsOf(const std::array<int, 3>& at) const {
    core::Bounds bounds;
    for (int axis = 0; axis < 3; ++axis) {
        bounds.low[axis] = at[axis] == 0 ? -core::infinity : boundary(at[axis], axis) - rounding;
        bounds.high[axis] = at[axis] + 1 == count[axis] ? core::infinity : boundary(at[axis] + 1, axis) + rounding;
    }
    return bounds;
}

}  // namespace gr
