#include "gr/grid.h"

#include "core/parallel.h"
#include "gr/grid_outliers.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace gr {

using core::Bounds;
using core::Vec3f;

// Builds levels from the top down. What they hold does not depend on threads.
class GridBuilder {
public:
    GridBuilder(Grid& grid, std::span<const Bounds> bounds, int threads, double refinement)
        : grid_(grid), bounds_(bounds), threads_(threads), refinement_(refinement) {}

    void build() {
        std::vector<std::uint32_t> all(bounds_.size());
        std::iota(all.begin(), all.end(), 0u);
        grid_.outliers_ = takeOutliers(bounds_, all);
        Part whole = *levelFor(all, boxOf(bounds_, all), 0);
        grid_.levels_ = std::move(whole.levels);
        grid_.bricks_ = std::move(whole.bricks);
        grid_.cells_ = std::move(whole.cells);
        grid_.items_ = std::move(whole.items);
    }

private:
    using Level = Grid::Level;
    using Brick = Grid::Brick;
    using Items = std::span<const std::uint32_t>;

    // A level with those within it, each counted from the part's first.
    struct Part {
        std::vector<Level> levels;
        std::vector<Brick> bricks;
        std::vector<std::uint32_t> cells;
        std::vector<std::uint32_t> items;
    };

    // Where a cell has more items than a cell should, and what became of it.
    struct Crowd {
        std::size_t cell;
        Bounds box;  // what the items fill of it
        std::optional<Part> inner;
    };

    static constexpr double mostCopies = 6;  // of an item in cells, on average
    // A cell with more items than this gets a level of its own, unless that would not keep them apart either.
    static constexpr std::size_t mostInCell = 8;
    static constexpr int mostDepth = 12;

    // Nothing for an inner level (depth > 0) that does not keep its items apart.
    std::optional<Part> levelFor(Items items, const Bounds& box, int depth) const {
        Part part;
        const double cells = bestResolution(items, box, depth).cells * refinement_;
        part.levels.emplace_back(box, std::max(cells, 1.0), grid_.errorPerUnit_);
        const Level& level = part.levels[0];
        const std::size_t occupied = occupy(level, items, part.bricks);
        std::vector<std::uint32_t> begins, sorted;
        const std::size_t largest = sort(part, items, occupied, begins, sorted);
        if (depth > 0 && 5 * largest > 4 * items.size()) return std::nullopt;
        std::vector<Crowd> crowds;
        if (depth < mostDepth && largest > mostInCell) crowds = split(part, begins, sorted, depth);
        finish(part, begins, sorted, crowds);
        return part;
    }

    // What a ray pays, in nanoseconds or so, to enter a level, to look at a slice of bricks or of cells, to look into a
    // cell, and to test an item.
    static constexpr double costOfLevel = 20, costOfBricks = 20, costOfSlice = 12, costOfCell = 4, costOfTest = 10;

    struct Choice {
        double cells, cost;
    };
    // Of some resolutions the one with which a ray takes the least time.
    Choice bestResolution(Items items, const Bounds& box, int depth) const {
        const double n = static_cast<double>(items.size());
        Choice best{1, core::infinity};
        std::array<int, 3> last{};
        for (double cells = n / 64; cells <= 64 * n; cells *= 4) {
            const Level level(box, std::max(cells, 1.0), grid_.errorPerUnit_);
            if (level.count == last) continue;
            last = level.count;
            const double listed = copies(level, items);
            if (listed > mostCopies * n && best.cost < core::infinity) break;
            const double cost = costOf(level, items, listed, depth);
            if (cost < best.cost) best = {cells, cost};
        }
        return best;
    }

    double costOf(const Level& level, Items items, double listed, int depth) const {
        std::vector<Brick> bricks;
        const double occupied = static_cast<double>(occupy(level, items, bricks));
        const auto isOccupied = [](const Brick& brick) { return brick.occupied != 0; };
        const double occupiedBricks = static_cast<double>(std::count_if(bricks.begin(), bricks.end(), isOccupied));
        // A line through a box is in it for 4 V / S on average, and goes 0.8 of that along its main axis; but rays end
        // at what they hit, half way. A slice with its slope and slack is 2.2 cells wide.
        const double x = level.count[0], y = level.count[1], z = level.count[2];
        const double slices = (depth == 0 ? 0.4 : 0.8) * 2 * x * y * z / (x * y + y * z + z * x);
        const double anyInBricks = std::min(1.0, 2 * occupiedBricks / static_cast<double>(bricks.size()));
        const double occupiedCells = 2.2 * slices * occupied / level.cellCount();
        return costOfLevel + slices * (costOfBricks / Level::brickSide + costOfSlice * anyInBricks) +
               occupiedCells * (costOfCell + costInCell(level, items, listed / occupied, depth));
    }

    // Of what is in an occupied cell.
    double costInCell(const Level& level, Items items, double inCell, int depth) const {
        const double n = static_cast<double>(items.size());
        if (inCell <= mostInCell || 4 * inCell > n) return costOfTest * inCell;
        if (depth > 0 || items.size() < 256) return costOfLevel + 12 * std::cbrt(inCell);
        // Look into the cells of a few.
        constexpr std::size_t samples = 4;
        std::array<double, samples> costs;
        core::parallelFor(samples, threads_, [&](int i) {
            const std::size_t sample = static_cast<std::size_t>(i);
            costs[sample] = costRound(level, items, items[(2 * sample + 1) * items.size() / (2 * samples)], depth);
        });
        return std::accumulate(costs.begin(), costs.end(), 0.) / samples;
    }

    // Of the cell that an item's middle is in.
    double costRound(const Level& level, Items items, std::uint32_t item, int depth) const {
        const core::Vec3f middle = 0.5f * (bounds_[item].low + bounds_[item].high);
        std::array<int, 3> at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = level.cellAt(level.coordinate(middle[axis], axis), axis);
        const Bounds cell = level.boundsOf(at);
        std::vector<std::uint32_t> inside;
        Bounds filled;
        for (const std::uint32_t other : items) {
            const Bounds part = bounds_[other].intersection(cell);
            if (part.isEmpty()) continue;
            inside.push_back(other);
            filled.include(part);
        }
        const double all = costOfTest * static_cast<double>(inside.size());
        return inside.size() <= mostInCell ? all : std::min(all, bestResolution(inside, filled, depth + 1).cost);
    }

    // How often items would be listed, in all.
    double copies(const Level& level, Items items) const {
        double sum = 0;
        inChunks(items.size(), [&](std::size_t first, std::size_t end) {
            double part = 0;
            for (std::size_t i = first; i < end; ++i) part += CellRange(level, bounds_[items[i]]).count();
            // Whole numbers: in any order the sum is the same.
            std::atomic_ref(sum).fetch_add(part, std::memory_order_relaxed);
        });
        return sum;
    }

    static constexpr std::size_t chunk = 4096;

    // Whether threads share the work on so many.
    bool isShared(std::size_t count) const { return count > chunk && threads_ > 1; }

    // Calls function(first, end) for chunks that together make 0 to count, many of them on all threads.
    template<class Function>
    void inChunks(std::size_t count, Function&& function) const {
        if (!isShared(count)) return function(0, count);
        core::parallelFor(static_cast<int>((count + chunk - 1) / chunk), threads_, [&](int i) {
            const std::size_t first = static_cast<std::size_t>(i) * chunk;
            function(first, std::min(first + chunk, count));
        });
    }

    // value += by, and what it was before. It is much quicker where no other thread sees the value.
    static std::uint32_t fetchAdd(std::uint32_t& value, std::uint32_t by, bool isShared) {
        if (isShared) return std::atomic_ref(value).fetch_add(by, std::memory_order_relaxed);
        return std::exchange(value, value + by);
    }
    static void addBits(std::uint64_t& value, std::uint64_t bits, bool isShared) {
        const std::atomic_ref shared(value);
        if (!isShared)
            value |= bits;
        else if ((shared.load(std::memory_order_relaxed) & bits) == 0)
            shared.fetch_or(bits, std::memory_order_relaxed);
    }

    template<class Function>
    void forEachItem(Items items, Function&& function) const {
        inChunks(items.size(), [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) function(items[i], bounds_[items[i]]);
        });
    }

    // Makes the level's bricks, and returns how many of their cells hold anything.
    std::size_t occupy(const Level& level, Items items, std::vector<Brick>& bricks) const {
        bricks.resize(level.brickCount());
        forEachItem(items, [&, shared = isShared(items.size())](std::uint32_t, const Bounds& bounds) {
            CellRange(level, bounds).forEach(level, [&](std::size_t brick, int bit) {
                addBits(bricks[brick].occupied, std::uint64_t(1) << bit, shared);
            });
        });
        std::uint32_t cells = 0;
        for (Brick& brick : bricks) {
            brick.firstCell = cells;
            cells += static_cast<std::uint32_t>(std::popcount(brick.occupied));
        }
        return cells;
    }

    // The items of all occupied cells, one cell behind the other, and where each begins. Returns how many the fullest
    // cell has.
    std::size_t sort(const Part& part, Items items, std::size_t occupied, std::vector<std::uint32_t>& begins,
                     std::vector<std::uint32_t>& sorted) const {
        const auto forEachListing = [&](auto&& function) {
            forEachItem(items, [&](std::uint32_t item, const Bounds& bounds) {
                CellRange(part.levels[0], bounds).forEach(part.levels[0], [&](std::size_t brick, int bit) {
                    const std::uint64_t before = (std::uint64_t(1) << bit) - 1;
                    function(item, part.bricks[brick].firstCell +
                                       static_cast<std::uint32_t>(std::popcount(part.bricks[brick].occupied & before)));
                });
            });
        };
        const bool shared = isShared(items.size());
        begins.assign(occupied + 1, 0);
        forEachListing([&](std::uint32_t, std::uint32_t cell) { fetchAdd(begins[cell], 1, shared); });
        std::uint32_t largest = 0, end = 0;
        for (std::uint32_t& begin : begins) {
            largest = std::max(largest, begin);
            end += begin;
            begin = end;
        }
        // Filled from behind, which leaves in `begins` where each begins.
        sorted.resize(end);
        forEachListing(
            [&](std::uint32_t item, std::uint32_t cell) { sorted[fetchAdd(begins[cell], ~0u, shared) - 1] = item; });
        // Threads came in any order.
        inChunks(occupied, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) std::sort(&sorted[0] + begins[i], &sorted[0] + begins[i + 1]);
        });
        return largest;
    }

    // Gives crowded cells levels of their own.
    std::vector<Crowd> split(const Part& part, const std::vector<std::uint32_t>& begins,
                             const std::vector<std::uint32_t>& sorted, int depth) const {
        const auto itemsIn = [&](std::size_t cell) {
            return Items(&sorted[begins[cell]], begins[cell + 1] - begins[cell]);
        };
        std::vector<Crowd> crowds;
        for (std::size_t brick = 0; brick < part.bricks.size(); ++brick) {
            std::uint64_t left = part.bricks[brick].occupied;
            for (std::size_t cell = part.bricks[brick].firstCell; left != 0; ++cell, left &= left - 1) {
                if (begins[cell + 1] - begins[cell] <= mostInCell) continue;
                const int bit = std::countr_zero(left);
                crowds.push_back({cell, boxIn(part.levels[0], static_cast<int>(brick), bit, itemsIn(cell)), {}});
            }
        }
        const auto build = [&](int i) {
            Crowd& crowd = crowds[static_cast<std::size_t>(i)];
            crowd.inner = levelFor(itemsIn(crowd.cell), crowd.box, depth + 1);
        };
        const int count = static_cast<int>(crowds.size());
        if (depth == 0)
            core::parallelFor(count, threads_, build);
        else
            for (int i = 0; i < count; ++i) build(i);
        std::erase_if(crowds, [](const Crowd& crowd) { return !crowd.inner; });
        return crowds;
    }

    // What the items of a cell fill of it.
    Bounds boxIn(const Level& level, int brick, int bit, Items items) const {
        const Bounds cell = level.boundsOf(level.cellOf(brick, bit));
        Bounds filled;
        for (const std::uint32_t item : items) filled.include(bounds_[item].intersection(cell));
        return filled;
    }

    // Lists what each cell holds: its items, or a level of its own. crowds: the cells with one, in their order.
    static void finish(Part& part, const std::vector<std::uint32_t>& begins, const std::vector<std::uint32_t>& sorted,
                       const std::vector<Crowd>& crowds) {
        reserve(part, begins, crowds);
        std::uint32_t levels = 1;
        auto crowd = crowds.begin();
        for (std::size_t cell = 0; cell + 1 < begins.size(); ++cell) {
            part.cells.push_back(static_cast<std::uint32_t>(part.items.size()));
            if (crowd != crowds.end() && crowd->cell == cell) {
                part.items.push_back(levels | Grid::isLevel);
                levels += static_cast<std::uint32_t>(crowd->inner->levels.size());
                ++crowd;
            } else {
                part.items.insert(part.items.end(), &sorted[0] + begins[cell], &sorted[0] + begins[cell + 1]);
            }
        }
        part.cells.push_back(static_cast<std::uint32_t>(part.items.size()));
        for (const Crowd& behind : crowds) append(*behind.inner, part);
    }

    // Makes room for just what finish adds.
    static void reserve(Part& part, const std::vector<std::uint32_t>& begins, const std::vector<Crowd>& crowds) {
        std::size_t levels = 1, bricks = part.bricks.size(), cells = begins.size(), items = begins.back();
        for (const Crowd& crowd : crowds) {
            levels += crowd.inner->levels.size();
            bricks += crowd.inner->bricks.size();
            cells += crowd.inner->cells.size();
            items += crowd.inner->items.size() + 1 - (begins[crowd.cell + 1] - begins[crowd.cell]);
        }
        part.levels.reserve(levels);
        part.bricks.reserve(bricks);
        part.cells.reserve(cells);
        part.items.reserve(items);
    }

    static void append(const Part& behind, Part& part) {
        const auto levels = static_cast<std::uint32_t>(part.levels.size());
        const auto bricks = static_cast<std::uint32_t>(part.bricks.size());
        const auto cells = static_cast<std::uint32_t>(part.cells.size());
        const auto items = static_cast<std::uint32_t>(part.items.size());
        for (Level level : behind.levels) {
            level.firstBrick += bricks;
            part.levels.push_back(level);
        }
        for (Brick brick : behind.bricks) {
            brick.firstCell += cells;
            part.bricks.push_back(brick);
        }
        for (const std::uint32_t cell : behind.cells) part.cells.push_back(cell + items);
        for (const std::uint32_t item : behind.items)
            part.items.push_back((item & Grid::isLevel) != 0 ? item + levels : item);
    }

    Grid& grid_;
    std::span<const Bounds> bounds_;
    int threads_;
    double refinement_;
};

Grid::Grid(std::span<const Bounds> bounds, float errorPerUnit, int threads, double refinement)
    : errorPerUnit_(errorPerUnit) {
    if (!bounds.empty()) GridBuilder(*this, bounds, threads, refinement).build();
}

std::size_t Grid::bytes() const {
    return levels_.capacity() * sizeof(Level) + bricks_.capacity() * sizeof(Brick) +
           (outliers_.capacity() + cells_.capacity() + items_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace gr
