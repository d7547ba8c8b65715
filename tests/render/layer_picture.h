// Pictures with layers, of scenes that tests build.
#pragma once

#include "render/render.h"
#include "render/test_scene.h"

namespace render {

inline constexpr std::array<Layer, layerCount> everyLayer{Layer::albedo, Layer::normal, Layer::depth, Layer::variance,
                                                          Layer::samples};

inline Film layersOf(const Integrator& integrator, const Camera& camera, const RenderSettings& settings, Film film) {
    Progress progress;
    const std::atomic<bool> stop = false;
    render(integrator, camera, settings, film, progress, stop);
    return film;
}

inline float numberAt(const Film& film, Layer layer, int x, int y) {
    return film.at(layer, x, y)[0];
}

inline core::Vec3f vectorAt(const Film& film, Layer layer, int x, int y) {
    const std::span<const float> v = film.at(layer, x, y);
    return {v[0], v[1], v[2]};
}

}  // namespace render
