// Going through the items of a grid that is being built, on many threads.
#pragma once

#include "core/parallel.h"
#include "gr/accelerators/grid_level.h"

#include <atomic>
#include <bit>
#include <span>
#include <utility>

namespace gr {

class GridWork {
public:
    using Items = std::span<const std::uint32_t>;  // by their places in `bounds`

    GridWork(std::span<const core::Bounds> bounds, float errorPerUnit, int threads)
        : bounds(bounds), errorPerUnit(errorPerUnit), threads(threads) {}

    const std::span<const core::Bounds> bounds;
    const float errorPerUnit;
    const int threads;

    // How many items, listings and bricks were looked at: what building takes, in a measure that is the same on every
    // machine.
    std::uint64_t steps() const { return steps_.load(std::memory_order_relaxed); }
    void count(std::size_t steps) const { steps_.fetch_add(steps, std::memory_order_relaxed); }

    // Items that one thread goes through at a time.
    static constexpr std::size_t chunk = 4096;
    // Whether threads share the work on so many.
    bool isShared(std::size_t count) const { return count > chunk && threads > 1; }

    // Calls function(first, end) for chunks that together make 0 to count, many of them on all threads.
    template<class Function>
    void inChunks(std::size_t count, Function&& function) const {
        if (!isShared(count)) return function(0, count);
        core::parallelFor(static_cast<int>((count + chunk - 1) / chunk), threads, [&](int i) {
            const std::size_t first = static_cast<std::size_t>(i) * chunk;
            function(first, std::min(first + chunk, count));
        });
    }
    // Calls function(item, its bounds) for each, and counts them.
    template<class Function>
    void forEach(Items items, Function&& function) const {
        count(items.size());
        inChunks(items.size(), [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) function(items[i], bounds[items[i]]);
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

    // How often a level would list its items, in all.
    double listings(const GridLevel& level, Items items) const {
        count(items.size());
        double sum = 0;
        inChunks(items.size(), [&](std::size_t first, std::size_t end) {
            double part = 0;
            for (std::size_t i = first; i < end; ++i) part += CellRange(level, bounds[items[i]]).count();
            // Whole numbers: in any order the sum is the same.
            std::atomic_ref(sum).fetch_add(part, std::memory_order_relaxed);
        });
        return sum;
    }

    // Marks which cells of a level's bricks hold anything. Returns how many they are.
    std::uint32_t occupy(const GridLevel& level, Items items, std::span<GridBrick> bricks) const {
        forEach(items, [&, shared = isShared(items.size())](std::uint32_t, const core::Bounds& box) {
            CellRange(level, box).forEach(level, [&](std::size_t brick, int bit) {
                addBits(bricks[brick].occupied, std::uint64_t(1) << bit, shared);
            });
        });
        count(bricks.size());
        std::uint32_t cells = 0;
        for (GridBrick& brick : bricks) {
            brick.firstCell = cells;
            cells += static_cast<std::uint32_t>(std::popcount(brick.occupied));
        }
        return cells;
    }

private:
    mutable std::atomic<std::uint64_t> steps_ = 0;
};

}  // namespace gr
