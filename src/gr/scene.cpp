#include "gr/scene.h"

#include "gr/polyhedron_surface.h"

#include <algorithm>

namespace gr {

core::Vec3f SurfacePoint::tangent() const {
    return tangentAt(*instance, objectNormal);
}

namespace {

// A mesh's own normals stand for a shape that is rounder than its faces. They change how light is reflected, never
// which side of a face something is on.
[[gnu::noinline]] void setSmoothNormal(SurfacePoint& surface, const Polyhedron& polyhedron, const Hit& hit,
                                       const core::Vec3f& direction, bool front) {
    const core::Vec3f objectNormal = polyhedron.shadingNormal<float>(hit);
    const core::Vec3f normal = glm::normalize(surface.instance->place.objectFromWorld().transposed(objectNormal));
    if (!(glm::dot(normal, surface.normal) > 0)) return;
    surface.smoothNormal = facing<float>(normal, direction, front);
    surface.objectNormal = objectNormal;
    surface.isSmooth = true;
}

}  // namespace

SurfacePoint Scene::surfaceAt(const core::Rayf& ray, const Hit& hit) const {
    const Instance& instance = instances[hit.instance];
    const PlacedPoint<float> point = placed(instance, ray, hit.t, [&](const core::Rayf& objectRay, const auto& margin) {
        const auto inObjectSpace = [&](const auto& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, const Polyhedron*>)
                return shape->template surfaceAt<float>(objectRay, hit, margin);
            else
                return shape.surfaceAt(objectRay, hit.t, margin);
        };
        return std::visit(inObjectSpace, instance.shape);
    });
    SurfacePoint surface;
    surface.position = point.position;
    surface.normal = point.normal;
    surface.objectNormal = point.objectNormal;
    surface.error = point.error;
    surface.instance = &instance;
    surface.isSmooth = false;
    if (const auto* polyhedron = std::get_if<const Polyhedron*>(&instance.shape);
        polyhedron && (*polyhedron)->hasNormals())
        setSmoothNormal(surface, **polyhedron, hit, ray.direction, point.front);
    surface.material = &materials[instance.material];
    const auto* square = std::get_if<Square>(&instance.shape);
    surface.light = square == nullptr ? nullptr : &lights.of<AreaLight>()[square->light];
    return surface;
}

bool Scene::hasInteriors() const {
    return std::any_of(interiors.begin(), interiors.end(), [](const auto& interior) { return interior.has_value(); });
}

std::size_t Scene::objectCount() const {
    std::size_t count = instances.size();
    for (const auto& polyhedron : polyhedra) count += polyhedron->triangleCount();
    return count;
}

std::size_t Scene::bytes() const {
    std::size_t bytes = instances.capacity() * sizeof(Instance) +
                        placements.size() * (sizeof(placements[0]) + sizeof(Placement::General)) +
                        materials.capacity() * sizeof(materials::Material) +
                        interiors.capacity() * sizeof(interiors[0]) + lights.bytes();
    for (const auto& polyhedron : polyhedra) bytes += polyhedron->bytes();
    bytes += (faces.parallelograms.capacity() + faces.triangles.capacity()) * sizeof(Face) +
             (large.capacity() + bodies.capacity()) * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace gr
