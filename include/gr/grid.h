// The report's uniform grid: space is cut into cells of equal size, each with a list of what reaches into it, and a ray
// looks only into the cells that it goes through. A cell that much reaches into gets a grid of its own, so that small
// things in a large scene cost no more than alone.
#pragma once

#include "core/bounds.h"
#include "gr/accelerator.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gr {

class Grid {
public:
    // Of a mesh.
    static constexpr std::uint32_t trianglesPerItem = 1;

    // bounds: of the items 0 to n - 1. They must hold every point at which an item may be reported to be hit by a ray
    // that starts at the origin; one that starts or hits at distance x from there may be off by errorPerUnit * x more.
    // threads: to build it with.
    Grid(std::span<const core::Bounds> bounds, float errorPerUnit, int threads);

    // Calls visit(item) for the items near the ray until it returns true, or nothing nearer than `nearest`, which visit
    // may lower, can follow. Every item that the ray hits at most as far as `nearest` is visited; some more than once.
    template<class Visit>
    void walk(const core::Rayf& ray, const float& nearest, TraversalCounts& counts, Visit&& visit) const;

    std::array<int, 3> resolution() const { return levels_.empty() ? std::array<int, 3>{} : levels_[0].count; }
    std::size_t levelCount() const { return levels_.size(); }
    std::size_t bytes() const;

private:
    friend class GridBuilder;

    // A box of cells.
    struct Level {
        core::Vec3f low;
        core::Vec3f cell;  // size
        core::Vec3f inverseCell;
        std::array<int, 3> count;
        std::uint32_t firstCell;
        float rounding;  // how far a coordinate may be from where its cell ends

        // Grows with x, so that what reaches beyond a place also reaches into the place's cell.
        int cellOf(float x, int axis) const {
            const float i = (x - low[axis]) * inverseCell[axis];
            if (!(i > 0)) return 0;
            const int last = count[axis] - 1;
            return i < static_cast<float>(last) ? static_cast<int>(i) : last;
        }
        float boundary(int i, int axis) const { return low[axis] + static_cast<float>(i) * cell[axis]; }
        std::uint32_t cellIndex(int x, int y, int z) const {
            return firstCell + static_cast<std::uint32_t>((z * count[1] + y) * count[0] + x);
        }
    };
    // The items from begin to end, or, where end is `isLevel`, the level `begin`.
    struct Cell {
        std::uint32_t begin, end;
    };
    static constexpr std::uint32_t isLevel = ~0u;

    template<class Visit>
    class Walk;

    std::vector<Level> levels_;  // the first is over everything
    std::vector<Cell> cells_;
    std::vector<std::uint32_t> items_;
    float errorPerUnit_;
};

// One ray's way. It goes slice by slice along the axis that it crosses most cells of, and within a slice through the
// few cells, four mostly, that it may touch: a 3D-DDA that is wide enough for all that may have been rounded.
template<class Visit>
class Grid::Walk {
public:
    Walk(const Grid& grid, const core::Rayf& ray, const float& nearest, TraversalCounts& counts, Visit& visit)
        : grid_(grid),
          ray_(ray),
          inverse_(1.f / ray.direction),
          nearest_(nearest),
          error_(grid.errorPerUnit_ * core::largestComponent(ray.origin)),
          errorPerT_(grid.errorPerUnit_ * core::largestComponent(ray.direction)),
          counts_(counts),
          visit_(visit) {
        recent_.fill(~0u);
    }

    // Returns whether visit asked to end.
    bool through(const Level& level) {
        float begin = 0, end = nearest_;
        if (!clip(level, begin, end)) return false;
        const int axis = mainAxis(level);
        const int step = ray_.direction[axis] > 0 ? 1 : -1;
        const float ahead = static_cast<float>(step);
        int slice = level.cellOf(at(axis, begin) - ahead * (errorAt(begin) + level.rounding), axis);
        const int last = level.cellOf(at(axis, end) + ahead * (errorAt(end) + level.rounding), axis);
        for (int left = (last - slice) * step; left >= 0; --left, slice += step) {
            const float entry = passing(level, axis, step > 0 ? slice : slice + 1, -1);
            if (entry > nearest_) return false;
            const float exit = passing(level, axis, step > 0 ? slice + 1 : slice, 1);
            if (throughSlice(level, axis, slice, core::max(entry, begin), core::min(exit, end))) return true;
        }
        return false;
    }

private:
    float at(int axis, float t) const { return ray_.origin[axis] + ray_.direction[axis] * t; }
    float errorAt(float t) const { return error_ + errorPerT_ * t; }

    // The part of the ray that may touch the level's box.
    bool clip(const Level& level, float& begin, float& end) const {
        for (int axis = 0; axis < 3; ++axis) {
            const float o = ray_.origin[axis];
            const float low = level.low[axis] - level.rounding,
                        high = level.boundary(level.count[axis], axis) + level.rounding;
            const float slack = error_ + grid_.errorPerUnit_ * core::max(std::abs(low), std::abs(high));
            if (ray_.direction[axis] == 0) {
                if (o < low - slack || o > high + slack) return false;
                continue;
            }
            const float t0 = (low - slack - o) * inverse_[axis], t1 = (high + slack - o) * inverse_[axis];
            begin = core::max(core::min(t0, t1), begin);
            end = core::min(core::max(t0, t1), end);
        }
        return begin <= end;
    }

    int mainAxis(const Level& level) const {
        const core::Vec3f speed = glm::abs(ray_.direction * level.inverseCell);
        return speed.x >= speed.y && speed.x >= speed.z ? 0 : speed.y >= speed.z ? 1 : 2;
    }

    // When the ray passes the i-th boundary, at the earliest (side -1) or at the latest (side 1).
    float passing(const Level& level, int axis, int i, int side) const {
        const float t = (level.boundary(i, axis) - ray_.origin[axis]) * inverse_[axis];
        const float slack = (errorAt(core::max(t, 0.f)) + level.rounding) * std::abs(inverse_[axis]);
        return t + static_cast<float>(side) * slack;
    }

    struct Interval {
        int first, last;
    };
    // The cells along an axis that the ray may touch between two times.
    Interval touched(const Level& level, int axis, float begin, float end) const {
        const float a = at(axis, begin), b = at(axis, end), error = errorAt(end);
        return {level.cellOf(core::min(a, b) - error, axis), level.cellOf(core::max(a, b) + error, axis)};
    }

    bool throughSlice(const Level& level, int axis, int slice, float begin, float end) {
        std::array<Interval, 3> cells;
        for (int k = 0; k < 3; ++k) cells[k] = k == axis ? Interval{slice, slice} : touched(level, k, begin, end);
        for (int z = cells[2].first; z <= cells[2].last; ++z)
            for (int y = cells[1].first; y <= cells[1].last; ++y)
                for (int x = cells[0].first; x <= cells[0].last; ++x)
                    if (throughCell(grid_.cells_[level.cellIndex(x, y, z)])) return true;
        return false;
    }

    bool throughCell(const Cell& cell) {
        ++counts_.cells;
        if (cell.end == isLevel) return through(grid_.levels_[cell.begin]);
        for (std::uint32_t i = cell.begin; i < cell.end; ++i) {
            const std::uint32_t item = grid_.items_[i];
            std::uint32_t& recent = recent_[item % recent_.size()];
            if (recent == item) continue;
            recent = item;
            if (visit_(item)) return true;
        }
        return false;
    }

    const Grid& grid_;
    const core::Rayf& ray_;
    core::Vec3f inverse_;  // infinite where the ray stands still
    const float& nearest_;
    float error_, errorPerT_;  // how far rounding may move a place on the ray, at its origin and for each t from there
    TraversalCounts& counts_;
    Visit& visit_;
    std::array<std::uint32_t, 16> recent_;  // items seen already reach into the next cell, too
};

template<class Visit>
void Grid::walk(const core::Rayf& ray, const float& nearest, TraversalCounts& counts, Visit&& visit) const {
    if (!levels_.empty()) Walk<Visit>(*this, ray, nearest, counts, visit).through(levels_[0]);
}

}  // namespace gr
