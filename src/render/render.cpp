#include "render/render.h"

#include "core/parallel.h"
#include "render/accumulate/alarm.h"
#include "render/accumulate/passes.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

namespace render {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

class PictureRenderer {
public:
    PictureRenderer(Accumulation& accumulation, const Integrator& integrator, const Camera& camera,
                    const RenderSettings& settings, Progress& progress, const std::atomic<bool>& stop,
                    const Checkpoints& checkpoints)
        : accumulation_(accumulation),
          integrator_(integrator),
          // A grid over the pixel that is left half empty would favour a part of it.
          view_{camera, settings.antialiasing, settings.seed, settings.samplesSpread()},
          settings_(settings),
          progress_(progress),
          stop_(stop),
          checkpoints_(checkpoints) {
        result_.threads = core::threadCount(settings.threads);
        result_.earlierRays = accumulation.rays.total();
        for (const Tile& tile : accumulation.tiles)
            pixels_ += static_cast<double>(tile.right - tile.left) * (tile.bottom - tile.top);
    }

    // The whole picture again and again, each time with more samples.
    RenderResult render() {
        const int before = accumulation_.samplesPerPixel();
        estimate();
        double secondsPerSample = 0;
        while (!isDone()) {
            expect(samplesExpected(before));
            const int first = accumulation_.samplesPerPixel();
            const double passStart = seconds();
            const int end = endOfPass(first, secondsPerSample);
            pass(end, first);
            if (accumulation_.samplesPerPixel() > first)
                secondsPerSample = (seconds() - passStart) / (accumulation_.samplesPerPixel() - first);
            estimate();
            if (stop_) {
                result_.stoppedBy = StoppedBy::interrupt;
                break;
            }
        }
        result_.rays = accumulation_.rays;
        result_.samples = accumulation_.samples;
        result_.droppedSamples = accumulation_.dropped;
        return result_;
    }

private:
    double seconds() const { return secondsSince(start_); }

    // Whether it is enough, and why.
    bool isDone() {
        if (result_.samplesPerPixel == 0) return false;
        if (settings_.noise > 0 && accumulation_.end == result_.samplesPerPixel && result_.noise &&
            *result_.noise <= settings_.noise)
            result_.stoppedBy = StoppedBy::noise;
        else if (settings_.time > 0 && seconds() >= settings_.time)
            result_.stoppedBy = StoppedBy::time;
        else if (result_.samplesPerPixel < settings_.mostSamples())
            return false;
        return true;
    }

    // Where nobody asks on the way, the next power of two is soon enough. A pass that was broken off is ended first.
    int endOfPass(int samples, double secondsPerSample) const {
        const int most = settings_.mostSamples();
        if (accumulation_.end > samples && accumulation_.end <= most) return accumulation_.end;
        if (!settings_.isOpenEnded())
            return std::min(static_cast<int>(std::bit_floor(static_cast<unsigned>(samples)) * 2) + (samples == 0),
                            most);
        const int end = std::min(nextPass(samples), most);
        if (settings_.time == 0 || secondsPerSample == 0) return end;
        const double inTime = std::max((settings_.time - seconds()) / secondsPerSample, 1.);
        return static_cast<int>(std::min<double>(end, samples + std::floor(inTime)));
    }

    // Goes to `end`, with a checkpoint now and then; breaks off when the time is over. A picture without any sample is
    // none, so the first has all the time it takes.
    void pass(int end, int first) {
        while (accumulation_.samplesPerPixel() < end && !stop_) {
            const double timeLeft = settings_.time > 0 && first > 0 ? settings_.time - seconds() : core::infinity;
            if (timeLeft <= 0) return;
            const double untilCheckpoint =
                checkpoints_.seconds > 0 ? std::max(nextCheckpoint_ - seconds(), 1e-3) : core::infinity;
            const double next = std::min(timeLeft, untilCheckpoint);
            const Alarm alarm(next < core::infinity ? next : 0, stop_);
            advance(accumulation_, integrator_, view_, end, result_.threads, progress_, alarm.flag());
            if (checkpoints_.seconds > 0 && !stop_ && seconds() >= nextCheckpoint_) checkpoint();
        }
    }

    // They take two percent of the time at the most.
    void checkpoint() {
        const double start = seconds();
        checkpoints_.write();
        const double taken = seconds() - start;
        nextCheckpoint_ = seconds() + std::max(checkpoints_.seconds, 49 * taken);
    }

    // How many samples each pixel has, and how noisy that is.
    void estimate() {
        result_.samplesPerPixel = accumulation_.samplesPerPixel();
        result_.noiseSums = accumulation_.noiseSums();
        if (!result_.noiseSums) return;
        estimate_ = estimateNoise(*result_.noiseSums, result_.samplesPerPixel, pixels_);
        result_.noise = estimate_->error;
    }

    // As far as can be told: it may be less than is there, and 0 while nothing can. before: how many there were when it
    // began.
    double samplesExpected(int before) const {
        const int samples = result_.samplesPerPixel;
        if (settings_.noise > 0 && !estimate_ && settings_.time == 0) return 0;
        if (settings_.time > 0 && samples == before) return 0;
        double expected = settings_.mostSamples();
        if (settings_.noise > 0 && estimate_)
            expected = std::min(expected, estimate_->samplesFor(settings_.noise, samples));
        if (settings_.time > 0) expected = std::min(expected, before + (samples - before) * settings_.time / seconds());
        return expected;
    }

    // Progress tells of what is still to be done.
    void expect(double samplesPerPixel) {
        const double left = samplesPerPixel * pixels_ - static_cast<double>(samplesBefore_);
        progress_.expectedSamples = samplesPerPixel == 0 ? 0 : static_cast<std::uint64_t>(std::max(left, 1.));
    }

    Accumulation& accumulation_;
    const Integrator& integrator_;
    const View view_;
    const RenderSettings& settings_;
    Progress& progress_;
    const std::atomic<bool>& stop_;
    const Checkpoints& checkpoints_;
    const Clock::time_point start_ = Clock::now();
    double nextCheckpoint_ = checkpoints_.seconds;
    const std::uint64_t samplesBefore_ = accumulation_.samples;
    double pixels_ = 0;
    std::optional<NoiseEstimate> estimate_;
    RenderResult result_;
};

}  // namespace

RenderResult render(Accumulation& accumulation, const Integrator& integrator, const Camera& camera,
                    const RenderSettings& settings, Progress& progress, const std::atomic<bool>& stop,
                    const Checkpoints& checkpoints) {
    return PictureRenderer(accumulation, integrator, camera, settings, progress, stop, checkpoints).render();
}

RenderResult render(const Integrator& integrator, const Camera& camera, const RenderSettings& settings,
                    image::Film& film, Progress& progress, const std::atomic<bool>& stop) {
    Accumulation accumulation(film);
    const RenderResult result = render(accumulation, integrator, camera, settings, progress, stop);
    accumulation.store(film);
    return result;
}

}  // namespace render
