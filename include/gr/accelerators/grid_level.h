// A box of equal cells, the grid's building block.
#pragma once

#include "core/bounds.h"
#include "core/lanes.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace gr {

struct GridLevel {
    static constexpr int brickSide = 4;

    core::Vec3f low;
    core::Vec3f cell;  // size
    core::Vec3f inverseCell;
    std::array<int, 3> count;
    std::array<int, 3> stride;  // from a brick to the next one along each axis
    std::uint32_t firstBrick = 0;
    float rounding;  // how far a coordinate may be from where its cell ends
    core::Bounds reach;  // of what is in the cells, wherever it was rounded to

    // About so many cells, cubes nearly, but where the box is thinner than they are. errorPerUnit: see Grid. shape:
    // what a cell's sides are to one another, where they are to be no cubes.
    GridLevel(const core::Bounds& box, double cells, float errorPerUnit, const core::Vec3f& shape = core::Vec3f(1));

    int bricks(int axis) const { return (count[axis] - 1) / brickSide + 1; }
    std::size_t brickCount() const { return static_cast<std::size_t>(stride[2]) * static_cast<std::size_t>(bricks(2)); }
    double cellCount() const { return 1. * count[0] * count[1] * count[2]; }
    bool isOneBrick() const { return std::max({count[0], count[1], count[2]}) <= brickSide; }
    float last(int axis) const { return static_cast<float>(count[axis] - 1); }
    // In cells from the low side.
    float coordinate(float x, int axis) const { return (x - low[axis]) * inverseCell[axis]; }
    int cellAt(float coordinate, int axis) const {
        return static_cast<int>(core::min(core::max(coordinate, 0.f), last(axis)));
    }
    float boundary(int i, int axis) const { return low[axis] + static_cast<float>(i) * cell[axis]; }
    // Of a cell, rounding included. What lies beyond the level belongs to its outermost cells.
    core::Bounds boundsOf(const std::array<int, 3>& at) const;

    // Of a cell in its brick.
    static int bit(int i, int axis) { return (i % brickSide) << (2 * axis); }
    // The cells of a brick that lie in a slice across an axis.
    static std::uint64_t sliceMask(int i, int axis) {
        constexpr std::array<std::uint64_t, 3> first{0x1111111111111111, 0x000f000f000f000f, 0x000000000000ffff};
        return first[static_cast<std::size_t>(axis)] << bit(i, axis);
    }
    // Where a cell is, of a level that knows itself by its brick and bit.
    std::array<int, 3> cellOf(int brick, int bit) const {
        return {brick % stride[1] * brickSide + bit % 4, brick % stride[2] / stride[1] * brickSide + bit / 4 % 4,
                brick / stride[2] * brickSide + bit / 16};
    }
};

// What the cells of a level are kept in, 4 x 4 x 4 of them.
struct GridBrick {
    std::uint64_t occupied = 0;  // a bit for each cell
    std::uint32_t firstCell = 0;  // the first occupied one
};

// The cells that a box reaches into.
struct CellRange {
    std::array<int, 3> first, last;

    CellRange(const GridLevel& level, const core::Bounds& box) {
        for (int axis = 0; axis < 3; ++axis) {
            first[axis] = level.cellAt(level.coordinate(box.low[axis], axis), axis);
            last[axis] = level.cellAt(level.coordinate(box.high[axis], axis), axis);
        }
    }
    double count() const { return 1. * (last[0] - first[0] + 1) * (last[1] - first[1] + 1) * (last[2] - first[2] + 1); }
    // Calls function(brick, bit) for each.
    template<class Function>
    void forEach(const GridLevel& level, Function&& function) const {
        constexpr int side = GridLevel::brickSide;
        for (int z = first[2]; z <= last[2]; ++z)
            for (int y = first[1]; y <= last[1]; ++y)
                for (int x = first[0]; x <= last[0]; ++x)
                    function(
                        static_cast<std::size_t>(x / side + y / side * level.stride[1] + z / side * level.stride[2]),
                        GridLevel::bit(x, 0) | GridLevel::bit(y, 1) | GridLevel::bit(z, 2));
    }
};

}  // namespace gr
