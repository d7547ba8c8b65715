// The arrays of a grid, or of a part of one that a thread builds by itself.
#pragma once

#include "gr/accelerators/grid_level.h"

#include <vector>

namespace gr {

// Levels, each behind those within it. They count from the part's first level, brick, cell and item.
struct GridPart {
    std::vector<GridLevel> levels;  // the last is over all others
    std::vector<GridBrick> bricks;
    // Where the items of each occupied cell begin, those of a level behind one another; one more is behind the last.
    std::vector<std::uint32_t> cells;
    std::vector<std::uint32_t> items;  // or, with the bit `isLevel`, a level

    static constexpr std::uint32_t isLevel = 1u << 31;

    std::size_t bytes() const;  // that are allocated
    // firstLevel: the level of this part that the items of the one behind count levels from.
    void append(GridPart behind, std::size_t firstLevel);
    // Of a part that is one level: takes all else out of cells that begin with an inner level.
    void compact();
    void shrink();  // to what is needed
};

// How many bytes parts take, for so many levels, bricks, occupied cells and items listed in them.
constexpr double gridBytes(double levels, double bricks, double cells, double items) {
    return sizeof(GridLevel) * levels + sizeof(GridBrick) * bricks + sizeof(std::uint32_t) * (levels + cells + items);
}
inline double gridBytes(const GridPart& part) {
    return gridBytes(static_cast<double>(part.levels.size()), static_cast<double>(part.bricks.size()),
                     static_cast<double>(part.cells.size() - part.levels.size()),
                     static_cast<double>(part.items.size()));
}

}  // namespace gr
