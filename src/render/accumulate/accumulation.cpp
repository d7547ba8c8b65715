#include "render/accumulate/accumulation.h"

#include "core/parallel.h"

#include <algorithm>
#include <mutex>

namespace render {
namespace {

// Columns are cut where those of the whole picture are: a pixel's noise is told by those beside it in its tile.
std::vector<Tile> tilesOf(const image::Film& film) {
    std::vector<Tile> tiles;
    const image::Window& held = film.held();
    const int right = held.left + held.width, bottom = held.top + held.height;
    for (int y = held.top; y < bottom; y += tileSize)
        for (int x = held.left, next; x < right; x = next) {
            next = std::min(x - x % tileSize + tileSize, right);
            tiles.emplace_back(x, y, next, std::min(y + tileSize, bottom), film.hasLayers());
        }
    return tiles;
}

// When stop turns true it ends soon, with as many samples as it has by then: the same number for each pixel.
void renderTile(Tile& tile, const Integrator& integrator, const View& view, int end, TileSums& sums,
                const std::atomic<bool>& stop) {
    while (tile.samples < end) {
        const SampleBlock block = sums.next(tile, end);
        integrator.render(view, block, sums.samples, stop);
        if (stop.load(std::memory_order_relaxed)) return;
        sums.add(tile, block, end);
    }
}

}  // namespace

Accumulation::Accumulation(const image::Film& film) : tiles(tilesOf(film)) {}

int Accumulation::samplesPerPixel() const {
    const auto fewest = std::min_element(tiles.begin(), tiles.end(),
                                         [](const Tile& a, const Tile& b) { return a.samples < b.samples; });
    return fewest->samples;
}

std::optional<NoiseSums> Accumulation::noiseSums() const {
    const int fewest = samplesPerPixel();
    if (fewest < leastSamplesForNoise) return std::nullopt;
    return NoiseSums(noise, fewest, fewest == end);
}

void Accumulation::store(image::Film& film) const {
    for (const Tile& tile : tiles) tile.store(film);
}

double Accumulation::bytesFor(int width, int lines, bool hasLayers) {
    const std::size_t bytesPerPixel = sizeof(PixelSum) + (hasLayers ? sizeof(PixelLayers) : 0);
    return static_cast<double>(bytesPerPixel) * width * lines;
}

void advance(Accumulation& accumulation, const Integrator& integrator, const View& view, int end, int threads,
             Progress& progress, const std::atomic<bool>& stop) {
    // The way from the last power of two is each pass's own.
    if (end != accumulation.end) accumulation.noise.rest = {};
    accumulation.end = end;
    std::mutex mutex;
    core::parallelFor(static_cast<int>(accumulation.tiles.size()), threads, [&](int i) {
        if (stop.load(std::memory_order_relaxed)) return;
        Tile& tile = accumulation.tiles[static_cast<std::size_t>(i)];
        TileSums sums(progress);
        renderTile(tile, integrator, view, end, sums, stop);
        const std::lock_guard lock(mutex);
        accumulation.rays += sums.tally.rays;
        accumulation.samples += sums.tally.samples;
        accumulation.dropped += sums.tally.dropped;
        accumulation.noise += sums.noise;
    });
}

}  // namespace render
