#include "render/render.h"

#include "core/parallel.h"
#include "render/accumulate/alarm.h"
#include "render/accumulate/passes.h"
#include "render/accumulate/tile.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>

namespace render {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<Tile> tilesOf(const image::Film& film) {
    std::vector<Tile> tiles;
    const int right = film.width(), bottom = film.startLine() + film.lines();
    for (int y = film.startLine(); y < bottom; y += tileSize)
        for (int x = 0; x < right; x += tileSize)
            tiles.push_back({x, y, std::min(x + tileSize, right), std::min(y + tileSize, bottom)});
    return tiles;
}

class PictureRenderer {
public:
    PictureRenderer(const Integrator& integrator, const Camera& camera, const RenderSettings& settings,
                    image::Film& film, Progress& progress, const std::atomic<bool>& stop)
        : integrator_(integrator),
          // A grid over the pixel that is left half empty would favour a part of it.
          view_{camera, settings.antialiasing, settings.seed, settings.isOpenEnded() ? 1 : settings.mostSamples()},
          settings_(settings),
          film_(film),
          progress_(progress),
          stop_(stop),
          tiles_(tilesOf(film)) {
        result_.threads = core::threadCount(settings.threads);
    }

    RenderResult render() {
        if (settings_.isOpenEnded())
            renderPasses();
        else
            renderAtOnce();
        result_.finished = !stop_.load();
        return result_;
    }

private:
    // Each tile to its end, one after the other: what only it needs is forgotten then.
    void renderAtOnce() {
        expect(settings_.mostSamples());
        pass(settings_.mostSamples(), stop_, [&](Tile& tile) {
            tile.store(film_);
            tile.pixels = std::vector<PixelSum>();
            tile.layers = std::vector<PixelLayers>();
        });
        if (!stop_) estimate(settings_.mostSamples());
    }

    // The whole picture again and again, each time with more samples.
    void renderPasses() {
        const int most = settings_.mostSamples();
        const Clock::time_point start = Clock::now();
        const Alarm alarm(settings_.time, stop_);
        double secondsPerSample = 0;
        while (!isDone(most, secondsSince(start))) {
            int end = std::min(nextPass(result_.samplesPerPixel), most);
            const double passStart = secondsSince(start);
            if (settings_.time > 0 && secondsPerSample > 0) {
                const double inTime = std::max((settings_.time - passStart) / secondsPerSample, 1.);
                end = std::min<double>(end, result_.samplesPerPixel + std::floor(inTime));
            }
            const int first = result_.samplesPerPixel;
            // A picture without any sample is none.
            pass(end, first == 0 ? stop_ : alarm.flag(), [](Tile&) {});
            if (stop_) return;
            estimate(end);
            secondsPerSample = (secondsSince(start) - passStart) / (end - first);
            expect(samplesExpected(most, secondsSince(start)));
        }
        for (const Tile& tile : tiles_) tile.store(film_);
    }

    // Whether it is enough, and why.
    bool isDone(int most, double seconds) {
        if (result_.samplesPerPixel == 0) return false;
        if (settings_.noise > 0 && result_.noise && *result_.noise <= settings_.noise)
            result_.stoppedBy = StoppedBy::noise;
        else if (settings_.time > 0 && seconds >= settings_.time)
            result_.stoppedBy = StoppedBy::time;
        else if (result_.samplesPerPixel < most)
            return false;
        return true;
    }

    template<class Finish>
    void pass(int samples, const std::atomic<bool>& stop, const Finish& finish) {
        noise_.rest = {};
        core::parallelFor(static_cast<int>(tiles_.size()), result_.threads, [&](int i) {
            if (stop.load(std::memory_order_relaxed)) return;
            Tile& tile = tiles_[static_cast<std::size_t>(i)];
            TileSums sums(film_.hasLayers(), progress_);
            renderTile(tile, samples, sums, stop);
            if (tile.samples == samples) finish(tile);
            const std::lock_guard lock(resultMutex_);
            result_.rays += sums.tally.rays;
            result_.samples += sums.tally.samples;
            result_.droppedSamples += sums.tally.dropped;
            noise_ += sums.noise;
        });
    }

    // Goes on until each pixel has had so many samples. When stop turns true it ends soon, with as many as it has by
    // then: the same number for each pixel.
    void renderTile(Tile& tile, int samples, TileSums& sums, const std::atomic<bool>& stop) const {
        while (tile.samples < samples) {
            const SampleBlock block = sums.next(tile, samples);
            integrator_.render(view_, block, sums.samples, stop);
            if (stop.load(std::memory_order_relaxed)) return;
            sums.add(tile, block, samples);
        }
    }

    // How many samples each pixel has, and how noisy that is, after a pass that should have gone to `end`.
    void estimate(int end) {
        const auto least = std::min_element(tiles_.begin(), tiles_.end(),
                                            [](const Tile& a, const Tile& b) { return a.samples < b.samples; });
        result_.samplesPerPixel = least->samples;
        if (least->samples < leastSamplesForNoise) return;
        result_.noiseSums = NoiseSums(noise_, least->samples, least->samples == end);
        estimate_ = estimateNoise(*result_.noiseSums, least->samples, pixels());
        result_.noise = estimate_->error;
    }

    // As far as can be told: it may be less than is there, and 0 while nothing can.
    double samplesExpected(int most, double seconds) const {
        const int samples = result_.samplesPerPixel;
        if (settings_.noise > 0 && !estimate_ && settings_.time == 0) return 0;
        double expected = most;
        if (settings_.noise > 0 && estimate_)
            expected = std::min(expected, estimate_->samplesFor(settings_.noise, samples));
        if (settings_.time > 0) expected = std::min(expected, samples * settings_.time / seconds);
        return expected;
    }

    void expect(double samplesPerPixel) {
        progress_.expectedSamples = static_cast<std::uint64_t>(samplesPerPixel * pixels());
    }

    double pixels() const { return static_cast<double>(film_.width()) * film_.lines(); }

    const Integrator& integrator_;
    const View view_;
    const RenderSettings& settings_;
    image::Film& film_;
    Progress& progress_;
    const std::atomic<bool>& stop_;
    std::vector<Tile> tiles_;
    NoiseSteps noise_;
    std::optional<NoiseEstimate> estimate_;
    RenderResult result_;
    std::mutex resultMutex_;
};

}  // namespace

double sumBytesFor(const RenderSettings& settings, int width, int lines) {
    if (!settings.isOpenEnded()) return 0;
    const std::size_t bytesPerPixel = sizeof(PixelSum) + (settings.layers.empty() ? 0 : sizeof(PixelLayers));
    return static_cast<double>(bytesPerPixel) * width * lines;
}

RenderResult render(const Integrator& integrator, const Camera& camera, const RenderSettings& settings,
                    image::Film& film, Progress& progress, const std::atomic<bool>& stop) {
    return PictureRenderer(integrator, camera, settings, film, progress, stop).render();
}

}  // namespace render
