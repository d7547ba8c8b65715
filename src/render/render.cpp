#include "render/render.h"

#include "core/parallel.h"
#include "render/pixel_layers.h"

#include <mutex>

namespace render {
namespace {

constexpr int tileSize = 16;  // pixels: small enough that the last tiles keep every thread busy

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

// One thread's work on one tile of the picture.
class TileRenderer {
public:
    TileRenderer(const Integrator& integrator, const View& view, Film& film, const std::atomic<bool>& stop,
                 Progress& progress)
        : tally(progress), integrator_(integrator), view_(view), film_(film), stop_(stop) {}

    Tally tally;

    // A few samples of each pixel at a time, which fit in the processor's own memory.
    void render(int left, int top) {
        SampleBlock block{left,
                          top,
                          std::min(left + tileSize, film_.width()),
                          std::min(top + tileSize, film_.startLine() + film_.lines()),
                          0,
                          0};
        pixels_.assign(static_cast<std::size_t>(block.pixels()), {});
        for (; block.first < view_.samplesPerPixel; block.first = block.end) {
            block.end = block.first + std::min(samplesAtOnce, view_.samplesPerPixel - block.first);
            samples_.radiance.resize(static_cast<std::size_t>(block.size()));
            if (film_.hasLayers()) samples_.first.assign(samples_.radiance.size(), {});
            integrator_.render(view_, block, samples_, stop_);
            if (stop_.load(std::memory_order_relaxed)) return;
            add(block);
        }
        store(block);
    }

private:
    static constexpr int samplesAtOnce = 8;

    // The mean of the samples that are finite; in double, or a million of them would drown the last.
    struct Pixel {
        glm::dvec3 sum{0};
        int kept = 0;
        PixelLayers layers;
    };

    void add(const SampleBlock& block) {
        std::size_t i = 0;
        for (Pixel& pixel : pixels_)
            for (int sample = block.first; sample < block.end; ++sample, ++i) {
                const core::Rgbf& radiance = samples_.radiance[i];
                if (core::isFinite(radiance)) {
                    pixel.sum += glm::dvec3(radiance);
                    ++pixel.kept;
                    if (film_.hasLayers()) pixel.layers.add(radiance, samples_.first[i]);
                } else {
                    ++tally.dropped;
                }
            }
        tally.rays += samples_.rays;
        samples_.rays = {};
        tally.count(static_cast<std::uint64_t>(block.size()));
    }

    void store(const SampleBlock& block) const {
        for (int i = 0; i < block.pixels(); ++i) {
            const Pixel& pixel = pixels_[static_cast<std::size_t>(i)];
            film_.at(block.x(i), block.y(i)) =
                pixel.kept == 0 ? core::Rgbf(0) : core::Rgbf(pixel.sum / static_cast<double>(pixel.kept));
            if (film_.hasLayers()) pixel.layers.store(film_, block.x(i), block.y(i));
        }
    }

    const Integrator& integrator_;
    const View& view_;
    Film& film_;
    const std::atomic<bool>& stop_;
    Samples samples_;
    std::vector<Pixel> pixels_;
};

}  // namespace

RenderResult render(const Integrator& integrator, const Camera& camera, const RenderSettings& settings, Film& film,
                    Progress& progress, const std::atomic<bool>& stop) {
    const View view{camera, settings.antialiasing, settings.seed, settings.samplesPerPixel};
    const int columns = (film.width() + tileSize - 1) / tileSize;
    const int rows = (film.lines() + tileSize - 1) / tileSize;
    RenderResult result;
    result.threads = core::threadCount(settings.threads);
    std::mutex resultMutex;

    core::parallelFor(rows * columns, result.threads, [&](int tile) {
        if (stop.load(std::memory_order_relaxed)) return;
        TileRenderer renderer(integrator, view, film, stop, progress);
        renderer.render(tile % columns * tileSize, film.startLine() + tile / columns * tileSize);
        const std::lock_guard lock(resultMutex);
        result.rays += renderer.tally.rays;
        result.samples += renderer.tally.samples;
        result.droppedSamples += renderer.tally.dropped;
    });
    result.finished = !stop.load();
    return result;
}

}  // namespace render
