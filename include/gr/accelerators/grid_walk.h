// How a ray goes through a grid. To be included where Grid::walk is called.
#pragma once

#include "gr/accelerators/grid.h"
#include "gr/mesh/pack.h"

#include <bit>
#include <limits>

namespace gr {

// One ray's way. It goes slice by slice along the axis that it crosses most cells of, and within a slice through the
// few cells, four mostly, that it may touch: a 3D-DDA that is wide enough for all that may have been rounded.
template<class Visit>
class Grid::Walk {
public:
    Walk(const Grid& grid, const core::Rayf& ray, const float& nearest, TraversalCounts& counts, Visit& visit)
        : grid_(grid),
          ray_(ray),
          nearest_(nearest),
          error_(grid.errorPerUnit_ * core::largestComponent(ray.origin)),
          errorPerT_(grid.errorPerUnit_ * core::largestComponent(ray.direction)),
          counts_(counts),
          visit_(visit) {
        constexpr float most = std::numeric_limits<float>::max();
        inverse_ = glm::clamp(1.f / ray.direction, -most, most);
        recent_.fill(~0u);
    }

    // Returns whether visit asked to end.
    bool through(const Level& level) {
        float begin = 0, end = nearest_;
        if (!clip(level, begin, end)) return false;
        const Course course(*this, level, begin, end);
        int slice = level.cellAt(course.isForward ? course.low : course.high, course.axis);
        const int last = level.cellAt(course.isForward ? course.high : course.low, course.axis);
        const int step = course.isForward ? 1 : -1;
        if (level.isOneBrick()) return throughSlices(course, course.bricks->occupied, slice, last, step);
        for (;;) {
            const int first = slice / Level::brickSide * Level::brickSide;
            const int brickEnd =
                course.isForward ? std::min(first + Level::brickSide - 1, last) : std::max(first, last);
            if (course.entry(slice) > nearest_) return false;
            const std::uint64_t occupied = occupiedIn(course, first);
            if (occupied != 0 && throughSlices(course, occupied, slice, brickEnd, step)) return true;
            if (brickEnd == last) return false;
            slice = brickEnd + step;
        }
    }

private:
    // A ray as it goes through a level: where it is along two axes, u and v, is linear in where it is along the third.
    // All are counted in cells.
    struct Course {
        int axis, u, v;
        bool isForward;
        float low, high;  // from where to where along the axis,
        float axisSlack;  // which may be off by so much
        // The least u and v and the greatest that the ray may be at: start + slope * place, and at which end of a part
        // of the ray that is.
        PackLanes start, slope, last;
        xsimd::batch_bool<float, PackLanes::arch_type> isAtLow;
        float tStart, tSlope;  // the ray's t, at the earliest
        const Brick* bricks;
        int stride, uStride, vStride;

        Course(const Walk& walk, const Level& level, float begin, float end) {
            const core::Vec3f speed = walk.ray_.direction * level.inverseCell, size = glm::abs(speed);
            axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            u = axis == 2 ? 0 : axis + 1;
            v = axis == 0 ? 2 : axis - 1;
            isForward = speed[axis] > 0;
            const core::Vec3f slack = (walk.errorAt(end) + level.rounding) * level.inverseCell;
            const core::Vec3f from = (walk.ray_.origin + walk.ray_.direction * begin - level.low) * level.inverseCell;
            const float to = level.coordinate(walk.ray_.origin[axis] + walk.ray_.direction[axis] * end, axis);
            axisSlack = slack[axis];
            low = core::min(from[axis], to) - axisSlack;
            high = core::max(from[axis], to) + axisSlack;
            tSlope = level.cell[axis] * walk.inverse_[axis];
            tStart = begin - tSlope * from[axis] - axisSlack * std::abs(tSlope);
            const float uSlope = speed[u] * tSlope, uStart = from[u] - uSlope * from[axis];
            const float vSlope = speed[v] * tSlope, vStart = from[v] - vSlope * from[axis];
            start = PackLanes{uStart - slack[u], uStart + slack[u], vStart - slack[v], vStart + slack[v]};
            slope = PackLanes{uSlope, uSlope, vSlope, vSlope};
            last = PackLanes{level.last(u), level.last(u), level.last(v), level.last(v)};
            isAtLow = slope * PackLanes{1, -1, 1, -1} > PackLanes(0.f);
            bricks = &walk.grid_.part_.bricks[level.firstBrick];
            stride = level.stride[axis];
            uStride = level.stride[u];
            vStride = level.stride[v];
        }

        // The earliest t at which the ray may be in a slice.
        float entry(int slice) const { return tStart + tSlope * static_cast<float>(isForward ? slice : slice + 1); }

        // Which cells the ray may touch in some slices.
        struct Cells {
            alignas(16) std::int32_t bound[4];
            int uFirst() const { return bound[0]; }
            int uLast() const { return bound[1]; }
            int vFirst() const { return bound[2]; }
            int vLast() const { return bound[3]; }
        };
        Cells cells(int firstSlice, int slices) const {
            const PackLanes from(core::max(static_cast<float>(firstSlice) - axisSlack, low));
            const PackLanes to(core::min(static_cast<float>(firstSlice + slices) + axisSlack, high));
            const PackLanes place = start + slope * xsimd::select(isAtLow, from, to);
            Cells cells;
            xsimd::to_int(core::min(core::max(place, PackLanes(0.f)), last)).store_aligned(cells.bound);
            return cells;
        }
        const Brick& brick(int slice, int uCell, int vCell) const {
            return bricks[slice / Level::brickSide * stride + uCell / Level::brickSide * uStride +
                          vCell / Level::brickSide * vStride];
        }
    };

    float errorAt(float t) const { return error_ + errorPerT_ * t; }

    // The part of the ray that may touch the level's box.
    bool clip(const Level& level, float& begin, float& end) const {
        const core::Vec3f t0 = (level.reach.low - error_ - ray_.origin) * inverse_;
        const core::Vec3f t1 = (level.reach.high + error_ - ray_.origin) * inverse_;
        const core::Vec3f enter = glm::min(t0, t1), leave = glm::max(t0, t1);
        begin = std::max({begin, enter.x, enter.y, enter.z});
        end = std::min({end, leave.x, leave.y, leave.z});
        return begin <= end;
    }

    // Which cells are occupied in any of the bricks that the ray touches in the four slices from `first` on.
    std::uint64_t occupiedIn(const Course& course, int first) {
        constexpr int side = Level::brickSide;
        const auto cells = course.cells(first, side);
        std::uint64_t occupied = 0;
        for (int v = cells.vFirst(); v / side <= cells.vLast() / side; v += side)
            for (int u = cells.uFirst(); u / side <= cells.uLast() / side; u += side, ++counts_.cells)
                occupied |= course.brick(first, u, v).occupied;
        return occupied;
    }

    // occupied: cells that are, in any brick.
    bool throughSlices(const Course& course, std::uint64_t occupied, int first, int last, int step) {
        for (int slice = first;; slice += step) {
            if (course.entry(slice) > nearest_) return false;
            if ((occupied & Level::sliceMask(slice, course.axis)) != 0 && throughSlice(course, slice)) return true;
            if (slice == last) return false;
        }
    }

    bool throughSlice(const Course& course, int slice) {
        const auto cells = course.cells(slice, 1);
        for (int v = cells.vFirst(); v <= cells.vLast(); ++v)
            for (int u = cells.uFirst(); u <= cells.uLast(); ++u) {
                ++counts_.cells;
                const Brick& brick = course.brick(slice, u, v);
                const int place = Level::bit(slice, course.axis) | Level::bit(u, course.u) | Level::bit(v, course.v);
                if ((brick.occupied >> place & 1) != 0 && throughCell(brick, place)) return true;
            }
        return false;
    }

    bool throughCell(const Brick& brick, int place) {
        const std::uint64_t before = (std::uint64_t(1) << place) - 1;
        const std::uint32_t* cell =
            &grid_.part_.cells[brick.firstCell + static_cast<std::uint32_t>(std::popcount(brick.occupied & before))];
        for (std::uint32_t i = cell[0]; i < cell[1]; ++i) {
            const std::uint32_t item = grid_.part_.items[i];
            if ((item & GridPart::isLevel) != 0) return through(grid_.part_.levels[item & ~GridPart::isLevel]);
            std::uint32_t& recent = recent_[item % recent_.size()];
            if (recent == item) continue;
            recent = item;
            if (visit_(item)) return true;
        }
        return false;
    }

    const Grid& grid_;
    const core::Rayf& ray_;
    core::Vec3f inverse_;  // finite, so that no product with it is not a number
    const float& nearest_;
    float error_, errorPerT_;  // how far rounding may move a place on the ray, at its origin and for each t from there
    TraversalCounts& counts_;
    Visit& visit_;
    std::array<std::uint32_t, 16> recent_;  // items seen already reach into the next cell, too
};

template<class Visit>
void Grid::walk(const core::Rayf& ray, const float& nearest, TraversalCounts& counts, Visit&& visit) const {
    for (const std::uint32_t item : outliers_)
        if (visit(item)) return;
    if (!part_.levels.empty()) Walk<Visit>(*this, ray, nearest, counts, visit).through(part_.levels.back());
}

}  // namespace gr
