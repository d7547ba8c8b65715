// A part of the picture: what one thread renders at a time.
#pragma once

#include "render/integrator.h"
#include "render/pixel_layers.h"
#include "render/render.h"

namespace render {

inline constexpr int tileSize = 16;  // pixels: small enough that the last tiles keep every thread busy

// The mean of a pixel's finite samples; in double, or a million of them would drown the last.
struct PixelSum {
    glm::dvec3 sum{0};
    int kept = 0;
    core::Rgbf before{0};  // the mean when the number of samples was last a power of two

    core::Rgbf mean() const { return kept == 0 ? core::Rgbf(0) : core::Rgbf(sum / static_cast<double>(kept)); }
};

// Pixels (left, top) to (right - 1, bottom - 1).
struct Tile {
    int left, top, right, bottom;
    int samples = 0;  // of each pixel
    std::vector<PixelSum> pixels = {};
    std::vector<PixelLayers> layers = {};  // empty unless the film has some

    void store(Film& film) const;
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

// One thread's work on one tile.
class TileRenderer {
public:
    TileRenderer(const Integrator& integrator, const View& view, bool hasLayers, Progress& progress)
        : tally(progress), integrator_(integrator), view_(view), hasLayers_(hasLayers) {}

    Tally tally;
    NoiseSteps noise;

    // Goes on until each pixel has had `samples`. When stop turns true it ends soon, with as many as it has by then:
    // the same number for each pixel.
    void render(Tile& tile, int samples, const std::atomic<bool>& stop);

private:
    void add(Tile& tile, const SampleBlock& block);
    void measureNoise(const Tile& tile);

    const Integrator& integrator_;
    const View& view_;
    bool hasLayers_;
    Samples samples_;
    std::vector<core::Rgbf> before_, after_;
};

}  // namespace render
