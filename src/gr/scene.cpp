#include "gr/scene.h"

namespace gr {

core::Vec3f SurfacePoint::offsetFrom(const core::Vec3f& position, const core::Vec3f& side, float error) {
    // The plane moves by the support of the error's cube in the direction of `side`.
    return position + side * (error * (std::abs(side.x) + std::abs(side.y) + std::abs(side.z)));
}

SurfacePoint Scene::surfaceAt(const core::Rayf& ray, const Hit& hit) const {
    const Instance& instance = instances[hit.instance];
    const auto inObjectSpace = [&](const auto& shape) {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, const Polyhedron*>)
            return shape->surfaceAt(hit);
        else
            return shape.surfaceAt(instance.toObject(ray), hit);
    };
    const ShapePoint point = std::visit(inObjectSpace, instance.shape);

    SurfacePoint surface;
    surface.position = instance.worldFromObject.point(point.position);
    surface.normal = glm::normalize(instance.objectFromWorld.transposed(point.normal));
    surface.error = instance.error + instance.errorPerUnit * core::largestComponent(surface.position);
    surface.material = &materials[instance.material];
    surface.light = instance.light == Instance::notALight ? nullptr : &areaLights[instance.light];
    return surface;
}

std::size_t Scene::bytes() const {
    std::size_t bytes = instances.capacity() * sizeof(Instance) + materials.capacity() * sizeof(materials::Material) +
                        areaLights.capacity() * sizeof(AreaLight) + pointLights.capacity() * sizeof(PointLight);
    for (const auto& polyhedron : polyhedra) bytes += polyhedron->bytes();
    return bytes;
}

}  // namespace gr
