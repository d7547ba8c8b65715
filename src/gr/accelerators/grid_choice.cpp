#include "gr/accelerators/grid_choice.h"

#include <array>
#include <cmath>
#include <mutex>
#include <optional>

namespace gr {

using core::Bounds;
using core::Vec3f;

bool isEvenGrid(double items, double cells, double listings) {
    return 4 * listings <= 5 * items && 5 * (cells + 1) >= 4 * items;
}

namespace {

using Items = GridWork::Items;

// What a ray pays, in nanoseconds or so, to enter a level, to look at a slice of bricks or of cells, to look into a
// cell, and to test an item.
constexpr double costOfLevel = 20, costOfBricks = 20, costOfSlice = 12, costOfCell = 4, costOfTest = 10;

constexpr double mostCopies = 6;  // of an item in cells, on average

// A resolution, and what a level takes with it.
struct Candidate {
    double cells;  // as asked for
    GridLevel level;
    double listings = 0, occupied = 0, occupiedBricks = 0;

    double bytes() const { return gridBytes(1, static_cast<double>(level.brickCount()), listings, listings); }
};

class Chooser {
public:
    Chooser(const GridWork& work, Items items, const Bounds& box, double bytes, bool isInner)
        : work_(work),
          items_(items),
          n_(static_cast<double>(items.size())),
          box_(box),
          bytes_(bytes),
          isInner_(isInner) {}

    GridChoice choose(bool onlyEven) {
        std::vector<Candidate> candidates;
        for (std::optional<Candidate> next = coarsest(onlyEven); next; next = finer(*next)) candidates.push_back(*next);
        if (onlyEven && !isAnyEven(candidates)) return {};
        GridChoice best;
        for (Candidate& candidate : candidates) {
            occupy(candidate);
            const double cost = costOf(candidate);
            if (cost >= best.cost) continue;
            // Where more cells would be better still, there is more space between things than an even grid has.
            const bool isBestKnown = !isCutShort_ || &candidate != &candidates.back();
            best = {candidate.cells, shape_, cost, isBestKnown && isEven(candidate)};
        }
        return best;
    }

private:
    bool isTooLarge(const Candidate& candidate) const {
        return candidate.listings > mostCopies * n_ || candidate.bytes() > bytes_;
    }
    double allItems() const { return static_cast<double>(work_.bounds.size()); }
    // Counts no cells of those with too many listings.
    bool isAnyEven(std::vector<Candidate>& candidates) const {
        return std::any_of(candidates.begin(), candidates.end(), [&](Candidate& candidate) {
            if (!isEvenGrid(allItems(), allItems(), candidate.listings)) return false;
            occupy(candidate);
            return isEven(candidate);
        });
    }
    bool isEven(const Candidate& candidate) const {
        return isEvenGrid(allItems(), candidate.occupied, candidate.listings);
    }

    Candidate at(double cells) const {
        return {cells, GridLevel(box_, std::max(cells, 1.0), work_.errorPerUnit, shape_)};
    }
    Candidate listed(Candidate candidate) const {
        candidate.listings = work_.listings(candidate.level, items_);
        return candidate;
    }

    // The first to be looked at: with few cells, and fewer still where that is too large.
    std::optional<Candidate> coarsest(bool onlyEven) {
        const double few = n_ / 64;
        Candidate candidate = listed(at(few));
        if (!isTooLarge(candidate)) return candidate;
        if (onlyEven) return std::nullopt;
        if (candidate.listings > mostCopies * n_) {
            // Long things that lie side by side, such as wires, are kept apart by cells as long as they are.
            shape_ = meanSize();
            candidate = listed(at(few));
        }
        while (isTooLarge(candidate) && candidate.level.cellCount() > 1) candidate = listed(at(candidate.cells / 4));
        if (isTooLarge(candidate) && isInner_) return std::nullopt;
        return candidate;
    }

    std::optional<Candidate> finer(const Candidate& than) {
        for (double cells = 4 * than.cells; cells <= 64 * n_; cells *= 4) {
            Candidate candidate = at(cells);
            if (candidate.level.count == than.level.count) continue;
            candidate = listed(candidate);
            if (!isTooLarge(candidate)) return candidate;
            isCutShort_ = candidate.listings <= mostCopies * n_;
            return std::nullopt;
        }
        return std::nullopt;
    }

    // Of what the items fill of the box. Along an axis where that is too thin to be cut, as GridLevel sees it, all do.
    Vec3f meanSize() const {
        work_.count(items_.size());
        glm::dvec3 sum(0);
        for (const std::uint32_t item : items_)
            sum += glm::dvec3(glm::max(work_.bounds[item].intersection(box_).size(), Vec3f(0)));
        const float thin = 0x1p-16f * core::largestComponent(box_.size());
        Vec3f mean(glm::max(sum / n_, 0x1p-16 * thin));
        for (int axis = 0; axis < 3; ++axis)
            if (box_.size()[axis] < thin) mean[axis] = thin;
        return thin > 0 ? mean / core::largestComponent(mean) : Vec3f(1);
    }

    // Where that is not yet done.
    void occupy(Candidate& candidate) const {
        if (candidate.occupied > 0) return;
        std::vector<GridBrick> bricks(candidate.level.brickCount());
        candidate.occupied = work_.occupy(candidate.level, items_, bricks);
        work_.count(static_cast<std::size_t>(candidate.listings));
        candidate.occupiedBricks = static_cast<double>(
            std::count_if(bricks.begin(), bricks.end(), [](const GridBrick& brick) { return brick.occupied != 0; }));
    }

    double costOf(const Candidate& candidate) const {
        const GridLevel& level = candidate.level;
        // A line through a box is in it for 4 V / S on average, and goes 0.8 of that along its main axis; but rays end
        // at what they hit, half way. A slice with its slope and slack is 2.2 cells wide.
        const double x = level.count[0], y = level.count[1], z = level.count[2];
        const double slices = (isInner_ ? 0.8 : 0.4) * 2 * x * y * z / (x * y + y * z + z * x);
        const double anyInBricks =
            std::min(1.0, 2 * candidate.occupiedBricks / static_cast<double>(level.brickCount()));
        const double occupiedCells = 2.2 * slices * candidate.occupied / level.cellCount();
        return costOfLevel + slices * (costOfBricks / GridLevel::brickSide + costOfSlice * anyInBricks) +
               occupiedCells * (costOfCell + costInCell(candidate));
    }

    // Of what is in an occupied cell.
    double costInCell(const Candidate& candidate) const {
        const double inCell = candidate.listings / candidate.occupied;
        if (inCell <= mostInGridCell || 4 * inCell > n_) return costOfTest * inCell;
        if (isInner_ || items_.size() < 256) return costOfLevel + 12 * std::cbrt(inCell);
        // Look into the cells that a few items' middles are in.
        constexpr std::size_t samples = 4;
        std::array<std::array<int, 3>, samples> cells;
        std::array<double, samples> costs;
        double sum = 0;
        for (std::size_t i = 0; i < samples; ++i) {
            cells[i] = cellOfMiddle(candidate.level, items_[(2 * i + 1) * items_.size() / (2 * samples)]);
            const auto same = static_cast<std::size_t>(std::find(&cells[0], &cells[i], cells[i]) - &cells[0]);
            costs[i] = same < i ? costs[same] : costOfCellAt(candidate.level, cells[i]);
            sum += costs[i];
        }
        return sum / samples;
    }

    std::array<int, 3> cellOfMiddle(const GridLevel& level, std::uint32_t item) const {
        const Vec3f middle = 0.5f * (work_.bounds[item].low + work_.bounds[item].high);
        std::array<int, 3> at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = level.cellAt(level.coordinate(middle[axis], axis), axis);
        return at;
    }

    // Of the items in a cell, by themselves or in the level that they would have.
    double costOfCellAt(const GridLevel& level, const std::array<int, 3>& at) const {
        const Bounds cell = level.boundsOf(at);
        std::vector<std::uint32_t> inside;
        std::mutex mutex;
        work_.count(items_.size());
        work_.inChunks(items_.size(), [&](std::size_t first, std::size_t end) {
            std::vector<std::uint32_t> found;
            for (std::size_t i = first; i < end; ++i)
                if (!work_.bounds[items_[i]].intersection(cell).isEmpty()) found.push_back(items_[i]);
            const std::scoped_lock lock(mutex);
            inside.insert(inside.end(), found.begin(), found.end());
        });
        // Threads came in any order.
        if (work_.isShared(items_.size())) std::sort(inside.begin(), inside.end());
        const double all = costOfTest * static_cast<double>(inside.size());
        if (inside.size() <= mostInGridCell) return all;
        Bounds filled;
        for (const std::uint32_t item : inside) filled.include(work_.bounds[item].intersection(cell));
        const double bytes = bytes_ * static_cast<double>(inside.size()) / n_;
        return std::min(all, GridChoice::of(work_, inside, filled, bytes, true).cost);
    }

    const GridWork& work_;
    Items items_;
    double n_;
    const Bounds& box_;
    double bytes_;
    bool isInner_;
    Vec3f shape_{1};
    bool isCutShort_ = false;  // whether there is no room for a finer resolution, which might be better
};

}  // namespace

GridChoice GridChoice::of(const GridWork& work, Items items, const Bounds& box, double bytes, bool isInner,
                          bool onlyEven) {
    return Chooser(work, items, box, bytes, isInner).choose(onlyEven);
}

}  // namespace gr
