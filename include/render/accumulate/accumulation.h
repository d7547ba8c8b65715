// What has been rendered of a picture so far: a value, which can be gone on with, shown, written down and read again.
#pragma once

#include "render/accumulate/noise.h"
#include "render/accumulate/tile.h"

#include <atomic>
#include <optional>
#include <vector>

namespace render {

struct Accumulation {
    std::vector<Tile> tiles;
    NoiseSteps noise;  // how the samples so far have moved the means
    int end = 0;  // how many samples the pass goes to that is going on, or was the last
    RayCounts rays;
    std::uint64_t samples = 0;
    std::uint64_t dropped = 0;  // samples that were not finite: left out of their pixel's mean

    // Of nothing yet, for what the film holds of the picture, and its layers.
    explicit Accumulation(const image::Film& film);

    // That of the pixels that have the fewest. Where a pass was broken off, others have more.
    int samplesPerPixel() const;
    // What the noise is estimated from; fewer than 4 samples tell nothing.
    std::optional<NoiseSums> noiseSums() const;
    void store(image::Film& film) const;

    // width, lines: of what is held.
    static double bytesFor(int width, int lines, bool hasLayers);
};

// Goes on until each pixel has `end` samples, on so many threads, or until soon after stop has turned true. Every
// sample depends on (seed, pixel, sample number) alone, and a pixel's are added in their order: neither the number of
// threads nor where it was broken off changes a bit.
void advance(Accumulation& accumulation, const Integrator& integrator, const View& view, int end, int threads,
             Progress& progress, const std::atomic<bool>& stop);

}  // namespace render
