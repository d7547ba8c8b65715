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
    ~Tally() { tell(); }

    RayCounts rays;
    std::uint64_t samples = 0;
    std::uint64_t dropped = 0;

    void countSample() {
        if (++samples - toldSamples_ >= 256) tell();
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

class Renderer {
public:
    Renderer(const Integrator& integrator, const Camera& camera, const RenderSettings& settings,
             const std::atomic<bool>& stop)
        : integrator_(integrator), camera_(camera), settings_(settings), grid_(settings.samplesPerPixel), stop_(stop) {}

    void renderTile(Film& film, int left, int top, Tally& tally) const {
        const int right = std::min(left + tileSize, film.width());
        const int bottom = std::min(top + tileSize, film.startLine() + film.lines());
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) renderPixel(film, x, y, tally);
    }

private:
    // The mean of the samples that are finite; in double, or a million of them would drown the last.
    void renderPixel(Film& film, int x, int y, Tally& tally) const {
        glm::dvec3 sum(0);
        int kept = 0;
        PixelLayers layers;
        for (int sample = 0; sample < settings_.samplesPerPixel; ++sample) {
            if (stop_.load(std::memory_order_relaxed)) return;
            Sampler sampler(settings_.seed, x, y, sample);
            const core::Vec2f u = sampler.next2D();
            const core::Vec2f inPixel = settings_.antialiasing ? grid_.place(sample, u) : core::Vec2f(0.5f);
            const core::Vec2f place(static_cast<float>(x) + inPixel.x, static_cast<float>(y) + inPixel.y);
            const core::Rayf ray = camera_.hasLens() ? camera_.ray(place, sampler.next2D()) : camera_.ray(place);
            FirstSurface first;
            const core::Rgbf radiance =
                integrator_.radiance(ray, sampler, tally.rays, film.hasLayers() ? &first : nullptr);
            if (core::isFinite(radiance)) {
                sum += glm::dvec3(radiance);
                ++kept;
                if (film.hasLayers()) layers.add(radiance, first, camera_.depth(ray, first.distance));
            } else {
                ++tally.dropped;
            }
            tally.countSample();
        }
        film.at(x, y) = kept == 0 ? core::Rgbf(0) : core::Rgbf(sum / static_cast<double>(kept));
        if (film.hasLayers()) layers.store(film, x, y);
    }

    const Integrator& integrator_;
    const Camera& camera_;
    const RenderSettings& settings_;
    PixelGrid grid_;
    const std::atomic<bool>& stop_;
};

}  // namespace

RenderResult render(const Integrator& integrator, const Camera& camera, const RenderSettings& settings, Film& film,
                    Progress& progress, const std::atomic<bool>& stop) {
    const Renderer renderer(integrator, camera, settings, stop);
    const int columns = (film.width() + tileSize - 1) / tileSize;
    const int rows = (film.lines() + tileSize - 1) / tileSize;
    RenderResult result;
    result.threads = core::threadCount(settings.threads);
    std::mutex resultMutex;

    core::parallelFor(rows * columns, result.threads, [&](int tile) {
        if (stop.load(std::memory_order_relaxed)) return;
        Tally tally(progress);
        const int left = tile % columns * tileSize;
        const int top = film.startLine() + tile / columns * tileSize;
        renderer.renderTile(film, left, top, tally);
        const std::lock_guard lock(resultMutex);
        result.rays += tally.rays;
        result.samples += tally.samples;
        result.droppedSamples += tally.dropped;
    });
    result.finished = !stop.load();
    return result;
}

}  // namespace render
