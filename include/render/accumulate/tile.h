// A part of the picture: what one thread renders at a time.
#pragma once

#include "image/film.h"
#include "render/accumulate/noise.h"
#include "render/accumulate/pixel_layers.h"
#include "render/transport/integrator.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace render {

inline constexpr int tileSize = 16;  // pixels: small enough that the last tiles keep every thread busy

// Whether a part of a picture of that width has no tile of which another part has the rest of a line.
inline bool hasWholeTiles(const image::Window& part, int width) {
    const int right = part.left + part.width;
    return part.left % tileSize == 0 && (right % tileSize == 0 || right == width);
}

// The mean of a pixel's finite samples; in double, or a million of them would drown the last.
struct PixelSum {
    glm::dvec3 sum{0};
    int kept = 0;
    core::Rgbf before{0};  // the mean when the number of samples was last a power of two

    bool operator==(const PixelSum&) const = default;
    core::Rgbf mean() const { return kept == 0 ? core::Rgbf(0) : core::Rgbf(sum / static_cast<double>(kept)); }
};

// Pixels (left, top) to (right - 1, bottom - 1).
struct Tile {
    int left, top, right, bottom;
    bool hasLayers;
    int samples = 0;  // of each pixel
    std::vector<PixelSum> pixels;  // empty until the first
    std::vector<PixelLayers> layers;

    Tile(int left, int top, int right, int bottom, bool hasLayers)
        : left(left), top(top), right(right), bottom(bottom), hasLayers(hasLayers) {}
    // Makes room for the first sample.
    void begin();
    void store(image::Film& film) const;
};

// What other threads may look at while a picture is rendered.
struct Progress {
    std::atomic<std::uint64_t> samples{0};  // paths done
    std::atomic<std::uint64_t> rays{0};
    std::atomic<std::uint64_t> expectedSamples{0};  // in all, as far as can be told; 0: not yet
};

// Work done since progress was last told of it: shared counters are touched now and then only.
class Tally {
public:
    explicit Tally(Progress& progress) : progress_(progress) {}

    RayCounts rays;
    std::uint64_t samples = 0;
    std::uint64_t dropped = 0;

    void count(std::uint64_t more) {
        samples += more;
        tell();
    }

private:
    void tell() {
        progress_.samples.fetch_add(samples - toldSamples_, std::memory_order_relaxed);
        progress_.rays.fetch_add(rays.total() - toldRays_, std::memory_order_relaxed);
        toldSamples_ = samples;
        toldRays_ = rays.total();
    }

    Progress& progress_;
    std::uint64_t toldSamples_ = 0;
    std::uint64_t toldRays_ = 0;
};

// Adds one thread's samples to its tiles, block after block.
class TileSums {
public:
    explicit TileSums(Progress& progress) : tally(progress) {}

    Samples samples;  // of the block
    Tally tally;
    NoiseSteps noise;

    // What comes next of the tile's samples up to `end`; `samples` has room for it then.
    SampleBlock next(Tile& tile, int end);
    // Adds the block's samples, once they are there.
    void add(Tile& tile, const SampleBlock& block, int end);

private:
    void addSamples(Tile& tile, const SampleBlock& block);
    void measureNoise(const Tile& tile);

    std::vector<core::Rgbf> before_, after_;
};

}  // namespace render
