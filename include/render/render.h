// From a scene to a film, with all cores.
#pragma once

#include "image/film.h"
#include "render/accumulate/accumulation.h"
#include "render/settings.h"
#include "render/transport/camera.h"
#include "render/transport/integrator.h"

#include <atomic>
#include <functional>

namespace render {

// Why a render ended.
enum class StoppedBy { samplesPerPixel, noise, time, interrupt };

struct RenderResult {
    RayCounts rays;
    std::uint64_t earlierRays = 0;  // of all, those that were there when it began
    std::uint64_t samples = 0;
    std::uint64_t droppedSamples = 0;  // not finite: left out of their pixel's mean
    int threads = 0;
    int samplesPerPixel = 0;  // of every pixel; where it was broken off within a pass some have more
    std::optional<double> noise;  // the estimated relative error; fewer than 4 samples tell nothing
    std::optional<NoiseSums> noiseSums;  // what it was estimated from
    StoppedBy stoppedBy = StoppedBy::samplesPerPixel;
};

// What is done with what has been rendered so far, now and then.
struct Checkpoints {
    double seconds = 0;  // how often; 0: never
    std::function<void()> write = {};
};

// Goes on with the accumulation until the settings' samples, noise or time are reached, or until soon after stop has
// turned true. How that was found out changes no bit of a picture of as many samples.
RenderResult render(Accumulation& accumulation, const Integrator& integrator, const Camera& camera,
                    const RenderSettings& settings, Progress& progress, const std::atomic<bool>& stop,
                    const Checkpoints& checkpoints = {});

// The film's lines, from nothing.
RenderResult render(const Integrator& integrator, const Camera& camera, const RenderSettings& settings,
                    image::Film& film, Progress& progress, const std::atomic<bool>& stop);

}  // namespace render
