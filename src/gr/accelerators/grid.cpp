#include "gr/accelerators/grid.h"

#include "gr/accelerators/grid_choice.h"
#include "gr/accelerators/grid_outliers.h"

#include <numeric>

namespace gr {

using core::Bounds;

// Builds levels from the top down. What they hold does not depend on threads.
//
// Where things cannot be kept apart, cells within cells could list each of them over and over. So all levels together
// may take only so many bytes for each item, and the levels within one share what it leaves. That bounds the time as
// well: for each item that is listed anywhere a level is tried once, which takes a number of steps that only depends on
// the number of levels that it is within, and on the logarithm of how many items it has.
class GridBuilder {
public:
    GridBuilder(std::span<const Bounds> bounds, float errorPerUnit, int threads, double refinement)
        : work_(bounds, errorPerUnit, threads), refinement_(refinement) {}

    // Leaves the grid empty where it is to be even and would not be.
    void build(Grid& grid, bool onlyEven) const {
        std::vector<std::uint32_t> all(work_.bounds.size());
        std::iota(all.begin(), all.end(), 0u);
        work_.count(all.size());
        grid.outliers_ = takeOutliers(work_.bounds, all);
        const Bounds box = boxOf(work_.bounds, all);
        double bytes = bytesEach * static_cast<double>(all.size());
        const GridChoice choice = GridChoice::of(work_, all, box, bytes, false, onlyEven);
        if (!onlyEven || choice.isEven) {
            GridPart own;
            const std::size_t largest = makeCells(own, all, box, choice);
            all = {};  // to have the memory for the levels within
            addLevel(grid.part_, own, largest, 0, bytes);
            grid.part_.shrink();
        }
        grid.buildSteps_ = work_.steps();
    }

private:
    using Items = GridWork::Items;

    // A cell that has more items than a cell should.
    struct Crowd {
        std::uint32_t cell;
        std::uint32_t brick;
        int bit;
    };

    // What all levels together may take for each item.
    static constexpr double bytesEach = 96;
    // Of what an item takes in a cell, so much is not given back when the cell gets a level of its own: else there
    // could be any number of levels within levels.
    static constexpr double bytesKept = 1;
    // A cell's level may take so many times what it would where all cells took the same.
    static constexpr double mostShare = 3;
    static constexpr int mostDepth = 12;

    // Adds a level behind those within it, which this makes. largest: how many items its fullest cell has. bytes: how
    // many all that may take; what it does is taken from it.
    void addLevel(GridPart& part, GridPart& own, std::size_t largest, int depth, double& bytes) const {
        bytes -= gridBytes(own);
        if (depth < mostDepth && largest > mostInGridCell) {
            const std::size_t listed = own.items.size();
            split(part, own, depth, bytes);
            own.compact();
            bytes += (sizeof(std::uint32_t) - bytesKept) * static_cast<double>(listed - own.items.size());
        }
        part.append(std::move(own), 0);
    }

    // Makes a level alone. Returns how many items the fullest cell has.
    std::size_t makeCells(GridPart& own, Items items, const Bounds& box, const GridChoice& choice) const {
        const double cells = std::max(choice.cells * refinement_, 1.0);
        const GridLevel& level = own.levels.emplace_back(box, cells, work_.errorPerUnit, choice.shape);
        own.bricks.resize(level.brickCount());
        own.cells.resize(work_.occupy(level, items, own.bricks) + 1);
        return sort(own, items);
    }

    // Lists the items of all occupied cells, one cell behind the other, and where each begins.
    std::size_t sort(GridPart& own, Items items) const {
        const GridLevel& level = own.levels[0];
        const std::span begins = own.cells;
        const auto forEachListing = [&](auto&& function) {
            work_.forEach(items, [&](std::uint32_t item, const Bounds& bounds) {
                CellRange(level, bounds).forEach(level, [&](std::size_t at, int bit) {
                    const GridBrick& brick = own.bricks[at];
                    const std::uint64_t before = (std::uint64_t(1) << bit) - 1;
                    function(item,
                             brick.firstCell + static_cast<std::uint32_t>(std::popcount(brick.occupied & before)));
                });
            });
        };
        const bool shared = work_.isShared(items.size());
        forEachListing([&](std::uint32_t, std::uint32_t cell) { GridWork::fetchAdd(begins[cell], 1, shared); });
        std::uint32_t largest = 0, end = 0;
        for (std::uint32_t& begin : begins) {
            largest = std::max(largest, begin);
            end += begin;
            begin = end;
        }
        work_.count(std::size_t(2) * end);
        // Filled from behind, which leaves in `begins` where each begins.
        own.items.resize(end);
        const std::span sorted = own.items;
        forEachListing([&](std::uint32_t item, std::uint32_t cell) {
            sorted[GridWork::fetchAdd(begins[cell], ~0u, shared) - 1] = item;
        });
        // Threads came in any order.
        work_.inChunks(begins.size() - 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) std::sort(&sorted[0] + begins[i], &sorted[0] + begins[i + 1]);
        });
        return largest;
    }

    static std::size_t countOf(const GridPart& own, const Crowd& crowd) {
        return own.cells[crowd.cell + 1] - own.cells[crowd.cell];
    }

    static std::vector<Crowd> crowdsOf(const GridPart& own) {
        std::vector<Crowd> crowds;
        for (std::size_t brick = 0; brick < own.bricks.size(); ++brick) {
            std::uint64_t left = own.bricks[brick].occupied;
            for (std::uint32_t cell = own.bricks[brick].firstCell; left != 0; ++cell, left &= left - 1) {
                const Crowd crowd{cell, static_cast<std::uint32_t>(brick), std::countr_zero(left)};
                if (countOf(own, crowd) > mostInGridCell) crowds.push_back(crowd);
            }
        }
        return crowds;
    }

    // Gives crowded cells of a level levels of their own, in `part`. What one leaves of its bytes the next ones have.
    void split(GridPart& part, GridPart& own, int depth, double& bytes) const {
        const std::vector<Crowd> crowds = crowdsOf(own);
        std::size_t left = 0;
        for (const Crowd& crowd : crowds) left += countOf(own, crowd);
        const std::size_t total = left;
        // Else it is copied when it has grown, and takes twice the memory meanwhile.
        if (depth == 0) part.items.reserve(std::min(static_cast<std::size_t>(std::max(bytes, 0.)) / 4, 8 * total));
        for (auto first = crowds.begin(), end = first; first != crowds.end(); first = end) {
            std::size_t count = 0;
            do count += countOf(own, *end++);
            while (end != crowds.end() && isOneBatch(count + countOf(own, *end), total) && end - first < mostInBatch);
            const double each = std::min(mostShare / static_cast<double>(left), 1 / static_cast<double>(count)) * bytes;
            if (end - first > 1)
                bytes -= addBatch(part, own, {first, end}, depth, each);
            else if (const double taken = addInner(part, own, *first, depth, each); taken > 0) {
                setInner(own, *first, part);
                bytes -= taken;
            }
            left -= count;
        }
    }

    // Few items are not worth it to be shared among threads; and what is built at once must not be much, for it takes
    // memory twice. That does not depend on threads, as it is seen in the shares.
    static constexpr std::ptrdiff_t mostInBatch = 256;
    static bool isOneBatch(std::size_t count, std::size_t total) {
        return total > GridWork::chunk && count <= total / 8;
    }

    // Many at once. Returns how many bytes that took.
    double addBatch(GridPart& part, GridPart& own, std::span<const Crowd> crowds, int depth, double bytesEach) const {
        std::vector<GridPart> parts(crowds.size());
        std::vector<double> bytes(crowds.size());
        core::parallelFor(static_cast<int>(crowds.size()), work_.threads, [&](int i) {
            const auto index = static_cast<std::size_t>(i);
            bytes[index] = addInner(parts[index], own, crowds[index], depth, bytesEach);
        });
        for (std::size_t i = 0; i < crowds.size(); ++i) {
            if (parts[i].levels.empty()) continue;
            part.append(std::move(parts[i]), part.levels.size());
            setInner(own, crowds[i], part);
        }
        return std::accumulate(bytes.begin(), bytes.end(), 0.);
    }

    // bytesEach: how many the level and those within it may take for each item. Returns how many they took: 0 where
    // there are none, because the level would not keep the items apart, or because there is no room.
    double addInner(GridPart& part, const GridPart& own, const Crowd& crowd, int depth, double bytesEach) const {
        const GridLevel& level = own.levels[0];
        const Bounds cell = level.boundsOf(level.cellOf(static_cast<int>(crowd.brick), crowd.bit));
        const Items items = Items(own.items).subspan(own.cells[crowd.cell], countOf(own, crowd));
        Bounds filled;
        for (const std::uint32_t item : items) filled.include(work_.bounds[item].intersection(cell));
        const double most = bytesEach * static_cast<double>(items.size());
        const GridChoice choice = GridChoice::of(work_, items, filled, most, true);
        if (choice.cost == core::infinity) return 0;
        GridPart inner;
        const std::size_t largest = makeCells(inner, items, filled, choice);
        if (5 * largest > 4 * items.size()) return 0;
        double left = most;
        addLevel(part, inner, largest, depth + 1, left);
        return most - left;
    }

    static void setInner(GridPart& own, const Crowd& crowd, const GridPart& part) {
        own.items[own.cells[crowd.cell]] = static_cast<std::uint32_t>(part.levels.size() - 1) | GridPart::isLevel;
    }

    const GridWork work_;
    double refinement_;
};

Grid::Grid(std::span<const Bounds> bounds, float errorPerUnit, int threads, double refinement, bool onlyEven)
    : errorPerUnit_(errorPerUnit) {
    if (!bounds.empty()) GridBuilder(bounds, errorPerUnit, threads, refinement).build(*this, onlyEven);
}

bool Grid::isEven(std::size_t items) const {
    return levelCount() == 1 && isEvenGrid(static_cast<double>(items), static_cast<double>(part_.cells.size() - 1),
                                           static_cast<double>(part_.items.size()));
}

std::size_t Grid::bytes() const {
    return part_.bytes() + outliers_.capacity() * sizeof(std::uint32_t);
}

}  // namespace gr
