// Pictures with layers, of scenes that tests build.
#pragma once

#include "image/image_samples.h"
#include "render/render.h"
#include "render/test_scene.h"

namespace render {

using image::everyLayer;

inline image::Film layersOf(const Integrator& integrator, const Camera& camera, const RenderSettings& settings,
                            image::Film film) {
    Progress progress;
    const std::atomic<bool> stop = false;
    render(integrator, camera, settings, film, progress, stop);
    return film;
}

inline float numberAt(const image::Film& film, image::Layer layer, int x, int y) {
    return film.at(layer, x, y)[0];
}

inline core::Vec3f vectorAt(const image::Film& film, image::Layer layer, int x, int y) {
    const std::span<const float> v = film.at(layer, x, y);
    return {v[0], v[1], v[2]};
}

}  // namespace render
