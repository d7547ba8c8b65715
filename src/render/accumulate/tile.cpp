#include "render/accumulate/tile.h"

#include <algorithm>
#include <bit>

namespace render {

void Tile::begin() {
    if (!pixels.empty()) return;
    pixels.resize(static_cast<std::size_t>(right - left) * static_cast<std::size_t>(bottom - top));
    if (hasLayers) layers.resize(pixels.size());
}

void Tile::store(image::Film& film) const {
    if (pixels.empty()) return;
    std::size_t i = 0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x, ++i) {
            film.at(x, y) = pixels[i].mean();
            if (film.hasLayers()) layers[i].store(film, x, y);
        }
}

SampleBlock TileSums::next(Tile& tile, int end) {
    constexpr int samplesAtOnce = 8;  // of each pixel: they fit in the processor's own memory
    SampleBlock block{tile.left, tile.top, tile.right, tile.bottom, tile.samples, tile.samples};
    tile.begin();
    // A block ends at each power of two, where samples are spread most evenly and the noise is measured.
    const unsigned step = std::bit_ceil(static_cast<unsigned>(block.first) + 1) - static_cast<unsigned>(block.first);
    block.end = block.first + std::min({samplesAtOnce, end - block.first, static_cast<int>(step)});
    samples.radiance.resize(static_cast<std::size_t>(block.size()));
    if (tile.hasLayers) samples.first.assign(samples.radiance.size(), {});
    return block;
}

void TileSums::add(Tile& tile, const SampleBlock& block, int end) {
    addSamples(tile, block);
    const bool isPower = std::has_single_bit(static_cast<unsigned>(tile.samples));
    // The last two doublings tell how noisy it is, and the way from there.
    if ((isPower || tile.samples == end) && tile.samples > 1) measureNoise(tile);
    if (isPower)
        for (PixelSum& pixel : tile.pixels) pixel.before = pixel.mean();
}

void TileSums::addSamples(Tile& tile, const SampleBlock& block) {
    std::size_t i = 0;
    for (std::size_t p = 0; p < tile.pixels.size(); ++p)
        for (int sample = block.first; sample < block.end; ++sample, ++i) {
            const core::Rgbf& radiance = samples.radiance[i];
            if (core::isFinite(radiance)) {
                tile.pixels[p].sum += glm::dvec3(radiance);
                ++tile.pixels[p].kept;
                if (tile.hasLayers) tile.layers[p].add(radiance, samples.first[i]);
            } else {
                ++tally.dropped;
            }
        }
    tile.samples = block.end;
    tally.rays += samples.rays;
    samples.rays = {};
    tally.count(static_cast<std::uint64_t>(block.size()));
}

void TileSums::measureNoise(const Tile& tile) {
    NoiseStep& step = noise.to(tile.samples);
    const int before = static_cast<int>(std::bit_floor(static_cast<unsigned>(tile.samples) - 1));
    const double allOverNew = static_cast<double>(tile.samples) / (tile.samples - before);
    const std::size_t width = static_cast<std::size_t>(tile.right - tile.left);
    for (std::size_t line = 0; line < tile.pixels.size(); line += width) {
        before_.clear();
        after_.clear();
        for (std::size_t i = line; i < line + width; ++i) {
            before_.push_back(tile.pixels[i].before);
            after_.push_back(tile.pixels[i].mean());
        }
        step.add(before_, after_, allOverNew);
    }
}

}  // namespace render
