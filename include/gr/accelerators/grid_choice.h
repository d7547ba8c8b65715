// How finely a grid cuts a box into cells.
#pragma once

#include "gr/accelerators/grid_part.h"
#include "gr/accelerators/grid_work.h"

namespace gr {

// A cell with more items than this gets a level of its own, unless that would not keep them apart either.
inline constexpr std::size_t mostInGridCell = 8;

// Whether nearly each of the items has a cell for itself.
bool isEvenGrid(double items, double cells, double listings);

// Of some resolutions of a level the one with which a ray takes the least time.
struct GridChoice {
    double cells = 1;
    core::Vec3f shape{1};  // of a cell
    double cost = core::infinity;  // what a ray pays, in nanoseconds or so
    bool isEven = false;

    // box: what the items fill. bytes: the most that the level may take; where even one cell takes more, the cost is
    // infinite, but for the outermost level. isInner: for a level within another. onlyEven: the cost is infinite where
    // no resolution is even.
    static GridChoice of(const GridWork& work, GridWork::Items items, const core::Bounds& box, double bytes,
                         bool isInner, bool onlyEven = false);
};

}  // namespace gr
