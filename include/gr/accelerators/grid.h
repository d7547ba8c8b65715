// The report's uniform grid: space is cut into cells of equal size, each with a list of what reaches into it, and a ray
// looks only into the cells that it goes through. Bricks of 4 x 4 x 4 cells say in one word which of them hold
// anything, so that empty space costs next to nothing. A cell that much reaches into gets a grid of its own, so that
// small things in a large scene cost no more than alone.
#pragma once

#include "gr/accelerators/accelerator.h"
#include "gr/accelerators/grid_part.h"

#include <span>
#include <vector>

namespace gr {

class Grid {
public:
    // bounds: of the items 0 to n - 1. They must hold every point at which an item may be reported to be hit by a ray
    // that starts at the origin; one that starts or hits at distance x from there may be off by errorPerUnit * x more.
    // errorPerUnit: at least 2^-21. threads: to build it with. refinement: how many times as many cells as seem best,
    // to find out whether they are. onlyEven: not to build what is not even; nothing is found in it then.
    // Whatever the items are, building takes time in proportion to n log n, and never more than 200 bytes an item.
    Grid(std::span<const core::Bounds> bounds, float errorPerUnit, int threads, double refinement = 1,
         bool onlyEven = false);

    // Calls visit(item) for the items near the ray until it returns true, or nothing nearer than `nearest`, which visit
    // may lower, can follow. Every item that the ray hits at most as far as `nearest` is visited; some more than once.
    template<class Visit>
    void walk(const core::Rayf& ray, const float& nearest, TraversalCounts& counts, Visit&& visit) const;

    std::array<int, 3> resolution() const {
        return part_.levels.empty() ? std::array<int, 3>{} : part_.levels.back().count;
    }
    std::size_t levelCount() const { return part_.levels.size(); }
    // Whether nearly each of the items has a cell for itself.
    bool isEven(std::size_t items) const;
    std::size_t bytes() const;
    // How many items, listings and bricks were looked at to build it.
    std::uint64_t buildSteps() const { return buildSteps_; }

private:
    friend class GridBuilder;

    using Level = GridLevel;
    using Brick = GridBrick;
    template<class Visit>
    class Walk;

    std::vector<std::uint32_t> outliers_;  // items that are visited for every ray
    GridPart part_;  // the last level is over everything
    float errorPerUnit_;
    std::uint64_t buildSteps_ = 0;
};

}  // namespace gr
