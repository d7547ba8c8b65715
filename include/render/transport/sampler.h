// The random numbers of one path. They depend on (seed, pixel, sample) and on how many were drawn before in this path,
// so neither threads nor strips nor the order of pixels changes them.
#pragma once

#include "core/random.h"
#include "core/vec.h"

namespace render {

class Sampler {
public:
    // x, y: the pixel in the whole picture. sample: its number within the pixel.
    Sampler(std::uint64_t seed, int x, int y, int sample)
        : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
          counter_{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(sample),
                   0} {}

    // Uniform in [0, 1).
    float next1D() {
        if (used_ == block_.size()) {
            block_ = core::philox(counter_, key_);
            ++counter_[3];
            used_ = 0;
        }
        return core::toUnitInterval(block_[used_++]);
    }
    // Uniform in the unit square.
    core::Vec2f next2D() {
        const float x = next1D();
        const float y = next1D();
        return {x, y};
    }

private:
    core::RandomKey key_;
    core::RandomBlock counter_;
    core::RandomBlock block_{};
    std::size_t used_ = block_.size();
};

// One place a sample in the unit square: sample i of n falls in a cell of its own in the grid of n cells that is as
// near to square as n's divisors allow. The samples go round the cells in steps of about n / golden ratio, so that any
// part of them in a row is spread over the whole square.
class PixelGrid {
public:
    explicit PixelGrid(int samples);
    // u: uniform in the unit square.
    core::Vec2f place(int sample, const core::Vec2f& u) const {
        const std::int64_t cells = std::int64_t{columns_} * rows_;
        const int cell = static_cast<int>(sample * stride_ % cells);
        const float x = (static_cast<float>(cell % columns_) + u.x) * cellWidth_;
        const float y = (static_cast<float>(cell / columns_) + u.y) * cellHeight_;
        return {x, y};
    }
    int columns() const { return columns_; }
    int rows() const { return rows_; }

private:
    int columns_, rows_;
    std::int64_t stride_;  // has no divisor in common with the number of cells, so that each has its turn
    float cellWidth_, cellHeight_;
};

}  // namespace render
