#include "gr/grid.h"

#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace gr {

using core::Bounds;
using core::Vec3f;

// Builds levels from the top down. What they hold does not depend on threads.
class GridBuilder {
public:
    GridBuilder(Grid& grid, std::span<const Bounds> bounds, int threads)
        : grid_(grid), bounds_(bounds), threads_(threads) {}

    void build() {
        std::vector<std::uint32_t> all(bounds_.size());
        std::iota(all.begin(), all.end(), 0u);
        Bounds box;
        for (const Bounds& item : bounds_) box.include(item);
        Part whole;
        addLevel(all, box, 0, whole);
        grid_.levels_ = std::move(whole.levels);
        grid_.cells_ = std::move(whole.cells);
        takeItems(whole.items);
    }

private:
    using Level = Grid::Level;
    using Cell = Grid::Cell;
    using Items = std::span<const std::uint32_t>;

    // Levels with their cells and items, each counted from the part's first.
    struct Part {
        std::vector<Level> levels;
        std::vector<Cell> cells;
        std::vector<std::uint32_t> items;
    };

    static constexpr double cellsPerItem = 2;
    static constexpr double mostCopies = 6;  // of an item in cells, on average
    // A cell with more items than this gets a level of its own, unless that would not keep them apart either.
    static constexpr std::size_t mostInCell = 8;
    static constexpr int mostDepth = 12;

    // Leaves out the items of cells that have become levels.
    void takeItems(const std::vector<std::uint32_t>& items) const {
        std::size_t count = 0;
        for (const Cell& cell : grid_.cells_) count += cell.end == Grid::isLevel ? 0 : cell.end - cell.begin;
        grid_.items_.reserve(count);
        for (Cell& cell : grid_.cells_) {
            if (cell.end == Grid::isLevel) continue;
            const auto begin = static_cast<std::uint32_t>(grid_.items_.size());
            grid_.items_.insert(grid_.items_.end(), &items[0] + cell.begin, &items[0] + cell.end);
            cell = {begin, static_cast<std::uint32_t>(grid_.items_.size())};
        }
        grid_.levels_.shrink_to_fit();
        grid_.cells_.shrink_to_fit();
    }

    // Adds a level for the items, and those within it. Adds nothing, and returns false, for an inner one (depth > 0)
    // that does not keep them apart.
    bool addLevel(Items items, const Bounds& box, int depth, Part& part) const {
        double cells = cellsPerItem * static_cast<double>(items.size());
        Level level = levelOf(box, cells);
        while (cells > 1 && copies(level, items) > mostCopies * static_cast<double>(items.size()))
            level = levelOf(box, cells /= 2);
        const std::vector<std::uint32_t> counts = countItems(level, items);
        const std::size_t largest = *std::max_element(counts.begin(), counts.end());
        if (depth > 0 && 5 * largest > 4 * items.size()) return false;
        level.firstCell = static_cast<std::uint32_t>(part.cells.size());
        part.levels.push_back(level);
        fill(level, items, counts, part);
        if (depth < mostDepth && largest > mostInCell) split(level, counts.size(), depth, part);
        return true;
    }

    // A box of about so many cells, cubes nearly, but where the box is thinner than they are.
    static Level levelOf(const Bounds& box, double cells) {
        Level level;
        level.firstCell = 0;
        level.rounding = 0x1p-21f * box.reach();
        const float thinnest = core::max(0x1p-16f * core::largestComponent(box.size()), 8 * level.rounding);
        const glm::dvec3 size = glm::max(box.size(), Vec3f(core::max(thinnest, 1e-30f)));
        const double edge = edgeOf(size, cells);
        level.low = box.low;
        for (int axis = 0; axis < 3; ++axis) {
            level.count[axis] = static_cast<int>(std::clamp(std::round(size[axis] / edge), 1.0, 4096.0));
            level.cell[axis] = static_cast<float>(size[axis] / level.count[axis]);
            level.inverseCell[axis] = 1 / level.cell[axis];
        }
        return level;
    }

    // Of the cubes that cut a box into so many cells, one layer being the least along each axis.
    static double edgeOf(const glm::dvec3& size, double cells) {
        std::array<double, 3> sides{size.x, size.y, size.z};
        std::sort(sides.begin(), sides.end(), std::greater<>());
        double edge = std::cbrt(sides[0] * sides[1] * sides[2] / cells);
        if (sides[2] < edge) edge = std::sqrt(sides[0] * sides[1] / cells);
        if (sides[1] < edge) edge = sides[0] / cells;
        return edge;
    }

    // The cells of a level that an item reaches into.
    struct Range {
        std::array<int, 3> first, last;

        Range(const Level& level, const Bounds& item) {
            for (int axis = 0; axis < 3; ++axis) {
                first[axis] = level.cellOf(item.low[axis], axis);
                last[axis] = level.cellOf(item.high[axis], axis);
            }
        }
        double count() const {
            double product = 1;
            for (int axis = 0; axis < 3; ++axis) product *= last[axis] - first[axis] + 1;
            return product;
        }
    };

    // How often items would be listed, in all.
    double copies(const Level& level, Items items) const {
        double sum = 0;
        for (const std::uint32_t item : items) sum += Range(level, bounds_[item]).count();
        return sum;
    }

    template<class Function>
    static void forEachCell(const Level& level, const Bounds& item, Function&& function) {
        const auto [first, last] = Range(level, item);
        for (int z = first[2]; z <= last[2]; ++z)
            for (int y = first[1]; y <= last[1]; ++y)
                for (int x = first[0]; x <= last[0]; ++x) function(level.cellIndex(x, y, z) - level.firstCell);
    }

    // Calls function(i) for i from 0 to count - 1, many of them on all threads.
    template<class Function>
    void inChunks(std::size_t count, Function&& function) const {
        constexpr std::size_t chunk = 4096;
        const auto work = [&](std::size_t first) {
            for (std::size_t i = first; i < std::min(first + chunk, count); ++i) function(i);
        };
        if (count <= chunk) return work(0);
        core::parallelFor(static_cast<int>((count + chunk - 1) / chunk), threads_,
                          [&](int i) { work(static_cast<std::size_t>(i) * chunk); });
    }

    template<class Function>
    void forEachItem(Items items, Function&& function) const {
        inChunks(items.size(), [&](std::size_t i) { function(items[i], bounds_[items[i]]); });
    }

    // How many items each cell holds.
    std::vector<std::uint32_t> countItems(const Level& level, Items items) const {
        std::vector<std::uint32_t> counts(static_cast<std::size_t>(level.count[0]) *
                                          static_cast<std::size_t>(level.count[1]) *
                                          static_cast<std::size_t>(level.count[2]));
        forEachItem(items, [&](std::uint32_t, const Bounds& bounds) {
            forEachCell(level, bounds, [&](std::uint32_t cell) {
                std::atomic_ref(counts[cell]).fetch_add(1, std::memory_order_relaxed);
            });
        });
        return counts;
    }

    void fill(const Level& level, Items items, const std::vector<std::uint32_t>& counts, Part& part) const {
        part.cells.reserve(part.cells.size() + counts.size());
        std::uint32_t end = static_cast<std::uint32_t>(part.items.size());
        for (const std::uint32_t count : counts) {
            part.cells.push_back({end, end});
            end += count;
        }
        part.items.resize(end);
        Cell* cells = &part.cells[level.firstCell];
        forEachItem(items, [&](std::uint32_t item, const Bounds& bounds) {
            forEachCell(level, bounds, [&](std::uint32_t cell) {
                part.items[std::atomic_ref(cells[cell].end).fetch_add(1, std::memory_order_relaxed)] = item;
            });
        });
        // Threads came in any order.
        inChunks(counts.size(),
                 [&](std::size_t i) { std::sort(&part.items[0] + cells[i].begin, &part.items[0] + cells[i].end); });
    }

    // Gives crowded cells levels of their own.
    void split(const Level& level, std::size_t cellCount, int depth, Part& part) const {
        std::vector<std::uint32_t> crowded;
        for (std::uint32_t i = level.firstCell; i < level.firstCell + cellCount; ++i)
            if (part.cells[i].end - part.cells[i].begin > mostInCell) crowded.push_back(i);
        std::vector<Part> inner(crowded.size());
        const auto build = [&](int i) {
            const Cell& cell = part.cells[crowded[static_cast<std::size_t>(i)]];
            const Items items(&part.items[cell.begin], cell.end - cell.begin);
            const std::uint32_t place = crowded[static_cast<std::size_t>(i)] - level.firstCell;
            addLevel(items, boxIn(level, place, items), depth + 1, inner[static_cast<std::size_t>(i)]);
        };
        const int count = static_cast<int>(crowded.size());
        if (depth == 0)
            core::parallelFor(count, threads_, build);
        else
            for (int i = 0; i < count; ++i) build(i);
        for (std::size_t i = 0; i < crowded.size(); ++i)
            if (!inner[i].levels.empty()) append(inner[i], part.cells[crowded[i]], part);
    }

    // What the items of a cell fill of it.
    Bounds boxIn(const Level& level, std::uint32_t cell, Items items) const {
        const int index = static_cast<int>(cell);
        const int at[3] = {index % level.count[0], index / level.count[0] % level.count[1],
                           index / level.count[0] / level.count[1]};
        Bounds whole, filled;
        for (int axis = 0; axis < 3; ++axis) {
            // What lies beyond the level belongs to its outermost cells.
            const float beyond = core::infinity;
            whole.low[axis] = at[axis] == 0 ? -beyond : level.boundary(at[axis], axis) - level.rounding;
            whole.high[axis] =
                at[axis] + 1 == level.count[axis] ? beyond : level.boundary(at[axis] + 1, axis) + level.rounding;
        }
        for (const std::uint32_t item : items) filled.include(bounds_[item].intersection(whole));
        return filled;
    }

    // Adds a part behind another, in place of a cell there.
    static void append(const Part& inner, Cell& place, Part& part) {
        const auto levels = static_cast<std::uint32_t>(part.levels.size());
        const auto cells = static_cast<std::uint32_t>(part.cells.size());
        const auto items = static_cast<std::uint32_t>(part.items.size());
        place = {levels, Grid::isLevel};
        for (Level level : inner.levels) {
            level.firstCell += cells;
            part.levels.push_back(level);
        }
        for (Cell cell : inner.cells) {
            cell.begin += cell.end == Grid::isLevel ? levels : items;
            if (cell.end != Grid::isLevel) cell.end += items;
            part.cells.push_back(cell);
        }
        part.items.insert(part.items.end(), inner.items.begin(), inner.items.end());
    }

    Grid& grid_;
    std::span<const Bounds> bounds_;
    int threads_;
};

Grid::Grid(std::span<const Bounds> bounds, float errorPerUnit, int threads) : errorPerUnit_(errorPerUnit) {
    if (!bounds.empty()) GridBuilder(*this, bounds, threads).build();
}

std::size_t Grid::bytes() const {
    return levels_.capacity() * sizeof(Level) + cells_.capacity() * sizeof(Cell) +
           items_.capacity() * sizeof(std::uint32_t);
}

}  // namespace gr
