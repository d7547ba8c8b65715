#include "gr/scene.h"

namespace gr {

core::Vec3f SurfacePoint::tangent() const {
    const core::Vec3f& n = objectNormal;
    constexpr float beyondRounding = 0x1p-17f;
    const bool isPole = std::abs(n.x) + std::abs(n.z) <= beyondRounding * std::abs(n.y);
    return instance->place.worldFromObject().vector(isPole ? core::Vec3f(1, 0, 0) : core::Vec3f(n.z, 0, -n.x));
}

namespace {

core::Vec3f bent(const core::Vec3f& normal, const core::Vec3f& direction, bool front) {
    constexpr float beyondRounding = 0x1p-20f;
    const float length = glm::length(direction);
    const float wanted = front ? -beyondRounding : beyondRounding;
    return glm::normalize(normal + direction * ((wanted - glm::dot(direction, normal) / length) / length));
}

// A ray that comes along the surface must see the normal from the side that it came from, or it would go on from the
// other one: where rounding says otherwise, the normal is bent by as much.
inline core::Vec3f facing(const core::Vec3f& normal, const core::Vec3f& direction, bool front) {
    return (glm::dot(direction, normal) < 0) == front ? normal : bent(normal, direction, front);
}

// A mesh's own normals stand for a shape that is rounder than its faces. They change how light is reflected, never
// which side of a face something is on.
[[gnu::noinline]] void setSmoothNormal(SurfacePoint& surface, const Polyhedron& polyhedron, const Hit& hit,
                                       const core::Vec3f& direction, bool front) {
    const core::Vec3f objectNormal = polyhedron.shadingNormal(hit);
    const core::Vec3f normal = glm::normalize(surface.instance->place.objectFromWorld().transposed(objectNormal));
    if (!(glm::dot(normal, surface.normal) > 0)) return;
    surface.smoothNormal = facing(normal, direction, front);
    surface.objectNormal = objectNormal;
    surface.isSmooth = true;
}

}  // namespace

SurfacePoint Scene::surfaceAt(const core::Rayf& ray, const Hit& hit) const {
    const Instance& instance = instances[hit.instance];
    SurfacePoint surface;
    surface.error =
        instance.error + instance.errorPerUnit() * core::largestComponent(ray.origin + ray.direction * hit.t);

    // No coordinate of the step off the surface is larger than (1 + sqrt(3)) / 2 times the error, and rounding adds the
    // error once more: 2.4 in all, along each of the world's axes, and so on to the object's.
    const bool isInPlace = instance.place.isInPlace();
    const core::Transform map = instance.place.objectFromWorld();
    const core::Vec3f unit = isInPlace ? core::Vec3f(1) : glm::abs(map.x) + glm::abs(map.y) + glm::abs(map.z);
    const core::Vec3f margin = unit * (2.4f * surface.error);
    const core::Rayf objectRay = instance.place.toObject(ray);
    const auto inObjectSpace = [&](const auto& shape) {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, const Polyhedron*>)
            return shape->surfaceAt(objectRay, hit, margin);
        else
            return shape.surfaceAt(objectRay, hit, margin);
    };
    const ShapePoint point = std::visit(inObjectSpace, instance.shape);

    surface.position = isInPlace ? point.position : instance.place.worldFromObject().point(point.position);
    const core::Vec3f normal = isInPlace ? point.normal : map.transposed(point.normal);
    surface.normal = facing(glm::normalize(normal), ray.direction, point.front);
    surface.objectNormal = point.normal;
    surface.instance = &instance;
    surface.isSmooth = false;
    if (const auto* polyhedron = std::get_if<const Polyhedron*>(&instance.shape);
        polyhedron && (*polyhedron)->hasNormals())
        setSmoothNormal(surface, **polyhedron, hit, ray.direction, point.front);
    surface.material = &materials[instance.material];
    const auto* square = std::get_if<Square>(&instance.shape);
    surface.light = square == nullptr ? nullptr : &areaLights[square->light];
    return surface;
}

core::Rayf Scene::shadowRay(const core::Vec3f& start, const AreaLight& light, const core::Vec3f& target) const {
    // The end is rounded by how far away the ray starts, too.
    const float error = light.error + instances[light.instance].errorPerUnit() * core::largestComponent(start);
    const core::Vec3f end = SurfacePoint::offsetFrom(target, light.normal, error);
    return {start, end - start, 1.f};
}

std::size_t Scene::objectCount() const {
    std::size_t count = instances.size();
    for (const auto& polyhedron : polyhedra) count += polyhedron->triangleCount();
    return count;
}

std::size_t Scene::bytes() const {
    std::size_t bytes = instances.capacity() * sizeof(Instance) +
                        placements.size() * (sizeof(placements[0]) + sizeof(Placement::General)) +
                        materials.capacity() * sizeof(materials::Material) + areaLights.capacity() * sizeof(AreaLight) +
                        pointLights.capacity() * sizeof(PointLight);
    for (const auto& polyhedron : polyhedra) bytes += polyhedron->bytes();
    return bytes;
}

}  // namespace gr
