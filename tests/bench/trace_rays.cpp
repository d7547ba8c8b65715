#include "trace_rays.h"

#include "core/frame.h"
#include "core/warp.h"
#include "gr/tracer.h"
#include "render/accumulate/tile.h"
#include "render/transport/integrator.h"

namespace bench {
namespace {

constexpr int samplesPerPixel = 4;

// Those of the path through a place in the picture; sampler: its random numbers.
void addPath(PathRays& rays, const ScriptScene& of, const gr::Tracer<float>& tracer, const core::Vec2f& place,
             render::Sampler& sampler) {
    const core::Rayf ray = of.camera.ray<float>(place);
    rays.camera.add(ray);
    gr::TraversalCounts counts;
    const auto surface = tracer.surfaceAt(ray, tracer.nearest(ray, true, counts));
    if (!surface.isMet() || surface.light >= 0) return;
    const core::Vec3f normal = glm::dot(ray.direction, surface.normal) < 0 ? surface.normal : -surface.normal;
    const core::Vec3f start = surface.offset(normal);
    const auto& lamp = of.scene.lights.of<gr::AreaLight>().at(0);
    const auto light = lamp.sample(surface.position, sampler.next2D());
    if (light.pdfW > 0 && glm::dot(light.wi, normal) > 0) rays.shadow.add(gr::shadowRay(start, lamp, light.target));
    const core::Vec3f direction = core::squareToCosineHemisphere(sampler.next2D());
    rays.bounce.add({start, core::Frame<float>(normal).toWorld(direction)});
}

}  // namespace

PathRays raysOf(const ScriptScene& scene, const gr::Accelerator& accelerator) {
    PathRays rays;
    const gr::Tracer<float> tracer(scene.scene, accelerator, false);
    for (int top = 0; top < scene.height; top += render::tileSize)
        for (int left = 0; left < scene.width; left += render::tileSize) {
            const int right = std::min(left + render::tileSize, scene.width),
                      bottom = std::min(top + render::tileSize, scene.height);
            for (render::SampleWalk at({left, top, right, bottom, 0, samplesPerPixel}); !at.isOver(); at.next()) {
                render::Sampler sampler(1, at.x, at.y, at.sample);
                const core::Vec2f pixel(static_cast<float>(at.x), static_cast<float>(at.y));
                addPath(rays, scene, tracer, pixel + sampler.next2D(), sampler);
            }
        }
    for (RayPacks* packs : {&rays.camera, &rays.shadow, &rays.bounce}) packs->finish();
    return rays;
}

}  // namespace bench
