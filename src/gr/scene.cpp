#include "gr/scene.h"

#include "gr/accelerators/object_tree.h"
#include "gr/body_surface.h"

#include <algorithm>

namespace gr {

SurfacePoint<float> Scene::surfaceAt(const core::Rayf& ray, const Hit& hit, bool wantsCoordinates) const {
    SurfacePoint<float> surface;
    surface.t = hit.t;
    surface.light = -1;
    surface.isSmooth = false;
    BodySurface<float>(*this, hit.instance, ray, hit, true).set(surface, wantsCoordinates);
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
                        interiors.capacity() * sizeof(interiors[0]) + lights.bytes() +
                        nodeSpaces.capacity() * sizeof(core::Transform);
    for (const auto& polyhedron : polyhedra) bytes += polyhedron->bytes();
    for (const auto& csg : csgs) bytes += csg->bytes();
    if (sky) bytes += sky->bytes();
    if (operandMeshes) bytes += operandMeshes->bytes();
    bytes += (faces.parallelograms.capacity() + faces.triangles.capacity()) * sizeof(Face) +
             (large.capacity() + bodies.capacity()) * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace gr
