// From a scene to a film, with all cores.
#pragma once

#include "render/camera.h"
#include "render/film.h"
#include "render/integrator.h"

#include <atomic>

namespace render {

// What other threads may look at while a picture is rendered.
struct Progress {
    std::atomic<std::uint64_t> samples{0};  // paths done
    std::atomic<std::uint64_t> rays{0};
};

struct RenderResult {
    bool finished = false;  // false: stopped before the end, and the film is incomplete
    RayCounts rays;
    std::uint64_t samples = 0;
    std::uint64_t droppedSamples = 0;  // not finite: left out of their pixel's mean
    int threads = 0;
};

// Renders the film's lines. Every sample depends on (seed, pixel, sample number) alone, and a pixel's samples are added
// in their order by one thread: neither the number of threads nor the strips change a bit.
// stop: rendering ends soon after it turns true.
RenderResult render(const Integrator& integrator, const Camera& camera, const RenderSettings& settings, Film& film,
                    Progress& progress, const std::atomic<bool>& stop);

}  // namespace render
