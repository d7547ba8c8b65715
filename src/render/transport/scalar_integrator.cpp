#include "render/transport/integrator.h"

namespace render {

void ScalarIntegrator::render(const View& view, const SampleBlock& block, Samples& samples,
                              const std::atomic<bool>& stop) const {
    const PixelGrid grid(view.samplesPerPixel);
    for (SampleWalk at(block); !at.isOver() && !stop.load(std::memory_order_relaxed); at.next()) {
        Sampler sampler(view.seed, at.x, at.y, at.sample);
        const core::Vec2f u = sampler.next2D();
        const core::Vec2f inPixel = view.antialiasing ? grid.place(at.sample, u) : core::Vec2f(0.5f);
        const core::Vec2f place(static_cast<float>(at.x) + inPixel.x, static_cast<float>(at.y) + inPixel.y);
        const core::Rayf ray =
            view.camera.hasLens() ? view.camera.ray(place, sampler.next2D()) : view.camera.ray(place);
        FirstSurface first;
        samples.radiance[at.place] = radiance(ray, sampler, samples.rays, samples.first.empty() ? nullptr : &first);
        if (samples.first.empty()) continue;
        samples.first[at.place] = first;
        samples.first[at.place].distance = view.camera.depth(ray, first.distance);
    }
}

}  // namespace render
