#include "render/integrator.h"

namespace render {

void ScalarIntegrator::render(const View& view, const SampleBlock& block, Samples& samples,
                              const std::atomic<bool>& stop) const {
    const PixelGrid grid(view.samplesPerPixel);
    std::size_t i = 0;
    for (int pixel = 0; pixel < block.pixels(); ++pixel)
        for (int sample = block.first; sample < block.end; ++sample, ++i) {
            if (stop.load(std::memory_order_relaxed)) return;
            const int x = block.x(pixel), y = block.y(pixel);
            Sampler sampler(view.seed, x, y, sample);
            const core::Vec2f u = sampler.next2D();
            const core::Vec2f inPixel = view.antialiasing ? grid.place(sample, u) : core::Vec2f(0.5f);
            const core::Vec2f place(static_cast<float>(x) + inPixel.x, static_cast<float>(y) + inPixel.y);
            const core::Rayf ray =
                view.camera.hasLens() ? view.camera.ray(place, sampler.next2D()) : view.camera.ray(place);
            FirstSurface first;
            samples.radiance[i] = radiance(ray, sampler, samples.rays, samples.first.empty() ? nullptr : &first);
            if (samples.first.empty()) continue;
            samples.first[i] = first;
            samples.first[i].distance = view.camera.depth(ray, first.distance);
        }
}

}  // namespace render
