// The report's uniform grid: space is cut into cells of equal size, each with a list of what reaches into it, and a ray
// looks only into the cells that it goes through. Bricks of 4 x 4 x 4 cells say in one word which of them hold
// anything, so that empty space costs next to nothing. A cell that much reaches into gets a grid of its own, so that
// small things in a large scene cost no more than alone.
#pragma once

#include "gr/accelerator.h"
#include "gr/grid_level.h"

#include <span>
#include <vector>

namespace gr {

class Grid {
public:
    // bounds: of the items 0 to n - 1. They must hold every point at which an item may be reported to be hit by a ray
    // that starts at the origin; one that starts or hits at distance x from there may be off by errorPerUnit * x more.
    // errorPerUnit: at least 2^-21. threads: to build it with. refinement: how many times as many cells as seem best,
    // to find out whether they are.
    Grid(std::span<const core::Bounds> bounds, float errorPerUnit, int threads, double refinement = 1);

    // Calls visit(item) for the items near the ray until it returns true, or nothing nearer than `nearest`, which visit
    // may lower, can follow. Every item that the ray hits at most as far as `nearest` is visited; some more than once.
    template<class Visit>
    void walk(const core::Rayf& ray, const float& nearest, TraversalCounts& counts, Visit&& visit) const;

    std::array<int, 3> resolution() const { return levels_.empty() ? std::array<int, 3>{} : levels_[0].count; }
    std::size_t levelCount() const { return levels_.size(); }
    // Whether nearly each of the items has a cell for itself.
    bool isEven(std::size_t items) const {
        return levelCount() == 1 && 4 * items_.size() <= 5 * items && 5 * cells_.size() >= 4 * items;
    }
    std::size_t bytes() const;

private:
    friend class GridBuilder;

    using Level = GridLevel;

    struct Brick {
        std::uint64_t occupied = 0;  // a bit for each cell
        std::uint32_t firstCell = 0;  // the first occupied one
    };
    template<class Visit>
    class Walk;

    std::vector<std::uint32_t> outliers_;  // items that are visited for every ray
    std::vector<Level> levels_;  // the first is over everything
    std::vector<Brick> bricks_;
    // Where the items of each occupied cell begin, those of a level behind one another; one more is behind the last.
    std::vector<std::uint32_t> cells_;
    std::vector<std::uint32_t> items_;  // or, with the bit `isLevel`, a level
    static constexpr std::uint32_t isLevel = 1u << 31;
    float errorPerUnit_;
};

}  // namespace gr
