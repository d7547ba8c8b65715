#include "render/path_scene.h"

#include <algorithm>

namespace render {
namespace {

core::Rayf rayOf(const RayColumns& rays, int lane) {
    const auto vector = [lane](const float(&v)[3][mostLanes]) {
        return core::Vec3f(v[0][lane], v[1][lane], v[2][lane]);
    };
    return {vector(rays.origin), vector(rays.direction), rays.tMax[lane]};
}

void put(float (&columns)[3][mostLanes], int lane, const core::Vec3f& v) {
    for (int axis = 0; axis < 3; ++axis) columns[axis][lane] = v[axis];
}

}  // namespace

PathScene::PathScene(const gr::Scene& scene, const gr::Accelerator& accelerator)
    : scene(scene), accelerator(accelerator), hasInteriors(scene.hasInteriors()), lights(scene.areaLights) {
    for (const materials::Material& material : scene.materials) {
        hasAnisotropy |= std::visit([](const auto& bsdf) { return bsdf.isAnisotropic(); }, material);
    }
    hasNormals =
        std::any_of(scene.polyhedra.begin(), scene.polyhedra.end(), [](const auto& p) { return p->hasNormals(); });
    // Indices go through lanes as floats, which hold them up to 2^24.
    isInLanes = accelerator.testsAll() && !hasNormals && scene.objectCount() < (1u << 24);
    if (!isInLanes) return;
    faces = facesOf(scene);
    for (const gr::Instance& instance : scene.instances) {
        if (std::holds_alternative<gr::Sphere>(instance.shape)) spheres.push_back(&instance);
        if (std::holds_alternative<gr::Box>(instance.shape)) boxes.push_back(&instance);
    }
}

std::size_t PathScene::bytes() const {
    return (faces.parallelograms.capacity() + faces.triangles.capacity()) * sizeof(Face) +
           (spheres.capacity() + boxes.capacity()) * sizeof(const gr::Instance*) + lights.bytes();
}

void PathScene::nearest(const RayColumns& rays, std::uint32_t lanes, SurfaceColumns& surfaces,
                        gr::TraversalCounts& counts) const {
    core::forEachLane(lanes, [&](int lane) {
        const core::Rayf ray = rayOf(rays, lane);
        const std::optional<gr::Hit> hit = accelerator.intersect(ray, counts);
        surfaces.t[lane] = hit ? hit->t : core::infinity;
        if (!hit) return;
        const gr::SurfacePoint surface = scene.surfaceAt(ray, *hit);
        put(surfaces.position, lane, surface.position);
        put(surfaces.normal, lane, surface.normal);
        put(surfaces.shadingNormal, lane, surface.shadingNormal());
        if (hasAnisotropy) put(surfaces.tangent, lane, surface.tangent());
        surfaces.error[lane] = surface.error;
        surfaces.isSmooth[lane] = surface.isSmooth ? 1 : 0;
        surfaces.material[lane] = static_cast<float>(surface.instance->material);
        surfaces.light[lane] =
            surface.light == nullptr ? -1.f : static_cast<float>(surface.light - scene.areaLights.data());
    });
}

std::uint32_t PathScene::occluded(const RayColumns& rays, std::uint32_t lanes, gr::TraversalCounts& counts) const {
    std::uint32_t met = 0;
    core::forEachLane(lanes, [&](int lane) {
        if (accelerator.occluded(rayOf(rays, lane), counts)) met |= 1u << lane;
    });
    return met;
}

}  // namespace render
