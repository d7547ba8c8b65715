// From a scene to a film, with all cores.
#pragma once

#include "image/film.h"
#include "render/accumulate/noise.h"
#include "render/transport/camera.h"
#include "render/transport/integrator.h"

#include <atomic>

namespace render {

// What other threads may look at while a picture is rendered.
struct Progress {
    std::atomic<std::uint64_t> samples{0};  // paths done
    std::atomic<std::uint64_t> rays{0};
    std::atomic<std::uint64_t> expectedSamples{0};  // in all, as far as can be told; 0: not yet
};

// Why a render ended.
enum class StoppedBy { samplesPerPixel, noise, time };

struct RenderResult {
    bool finished = false;  // false: stopped before the end, and the film is incomplete
    RayCounts rays;
    std::uint64_t samples = 0;
    std::uint64_t droppedSamples = 0;  // not finite: left out of their pixel's mean
    int threads = 0;
    int samplesPerPixel = 0;  // of every pixel; where the time was over within a pass some have more
    std::optional<double> noise;  // the estimated relative error; fewer than 4 samples tell nothing
    std::optional<NoiseSums> noiseSums;  // what it was estimated from
    StoppedBy stoppedBy = StoppedBy::samplesPerPixel;
};

// Memory that a render takes beside the film. Where its end is open, pixels' sums are kept from pass to pass.
double sumBytesFor(const RenderSettings& settings, int width, int lines);

// Renders the film's lines. Every sample depends on (seed, pixel, sample number) alone, and a pixel's samples are added
// in their order: neither the number of threads nor the strips change a bit, and how it was found out how many samples
// there are does not, either.
// stop: rendering ends soon after it turns true.
RenderResult render(const Integrator& integrator, const Camera& camera, const RenderSettings& settings,
                    image::Film& film, Progress& progress, const std::atomic<bool>& stop);

}  // namespace render
