// What is rendered: the scene graph spread out into a flat list, in world space, never changed again.
#pragma once

#include "gr/accelerator.h"
#include "gr/face_list.h"
#include "gr/light.h"
#include "gr/offset.h"
#include "gr/placement.h"
#include "gr/shape.h"
#include "materials/material.h"

#include <vector>

namespace gr {

class Database;

// A shape at one place. Nodes' sizes and positions are part of the placement.
struct Instance {
    Placement place;
    Shape shape;
    std::uint32_t material = 0;  // index into Scene::materials
    // How far single precision may put a point of the surface off its true place, there and back from object space:
    // error + errorPerUnit() * the point's largest world coordinate.
    float error = 0;
    float errorPerUnit() const { return 0x1p-24f * (2 + 10 * place.condition()); }

    core::Bounds bounds() const;  // in the world, of every point at which a ray may be reported to hit it
};

// A surface where a ray met it, in the world.
struct SurfacePoint {
    core::Vec3f position;
    core::Vec3f normal;  // unit length, outward
    bool isSmooth;  // whether it is shaded with another normal,
    core::Vec3f smoothNormal;  // this one: unit length, on the normal's side both of the surface and of the ray
    core::Vec3f objectNormal;  // the shading normal in the object's own space, not of unit length
    float error;  // see Instance
    const Instance* instance;
    const materials::Material* material;
    const AreaLight* light;  // null for what does not emit

    core::Vec3f shadingNormal() const { return isSmooth ? smoothNormal : normal; }
    // Where a ray starts or ends that leaves the surface on the side of the normal (or, negated, on the other): so far
    // off it that it cannot meet it again, whatever was rounded.
    core::Vec3f offset(const core::Vec3f& side) const { return offsetFrom(position, side, error); }
    // The u axis of materials that have one, not of unit length: to the east, y being the object's own axis, and along
    // its x axis where the normal is that axis. It is the same all over a flat face, and has no seam on a round one.
    core::Vec3f tangent() const;
    template<class Real>
    static core::Vec3<Real> offsetFrom(const core::Vec3<Real>& position, const core::Vec3<Real>& side,
                                       const Real& error) {
        return gr::offsetFrom(position, side, error);
    }
};

// Where rays met an instance's shape, in the world.
template<class Real>
struct PlacedPoint {
    core::Vec3<Real> position;
    core::Vec3<Real> normal;  // unit length, outward
    core::Vec3<Real> objectNormal;  // in the object's own space, not of unit length
    core::Mask<Real> front;  // whether the ray came from the normal's side
    Real error;  // see Instance
};

// A ray that comes along the surface must see the normal from the side that it came from, or it would go on from the
// other one: where rounding says otherwise, the normal is bent by as much.
template<class Real>
core::Vec3<Real> facing(const core::Vec3<Real>& normal, const core::Vec3<Real>& direction,
                        const core::Mask<Real>& front) {
    const core::Mask<Real> isWrong = core::differ(glm::dot(direction, normal) < Real(0), front);
    if (!core::any(isWrong)) return normal;
    const Real beyondRounding(0x1p-20f);
    const Real length = glm::length(direction);
    const Real wanted = core::select(front, -beyondRounding, beyondRounding);
    const core::Vec3<Real> bent =
        glm::normalize(normal + direction * ((wanted - glm::dot(direction, normal) / length) / length));
    return core::select(isWrong, bent, normal);
}

// inObjectSpace: the ShapePoint of a ray in the object's space, with a margin.
template<class Real, class InObjectSpace>
PlacedPoint<Real> placed(const Instance& instance, const core::Ray<Real>& ray, const Real& t,
                         const InObjectSpace& inObjectSpace) {
    PlacedPoint<Real> placed;
    placed.error = Real(instance.error) +
                   Real(instance.errorPerUnit()) * core::largestComponent<Real>(ray.origin + ray.direction * t);

    // No coordinate of the step off the surface is larger than (1 + sqrt(3)) / 2 times the error, and rounding adds the
    // error once more: 2.4 in all, along each of the world's axes, and so on to the object's.
    const bool isInPlace = instance.place.isInPlace();
    const core::Transform map = instance.place.objectFromWorld();
    const core::Vec3f unit = isInPlace ? core::Vec3f(1) : glm::abs(map.x) + glm::abs(map.y) + glm::abs(map.z);
    const core::Vec3<Real> margin = core::broadcast<Real>(unit) * (Real(2.4f) * placed.error);
    const ShapePoint<Real> point = inObjectSpace(instance.place.toObject(ray), margin);

    placed.position = isInPlace ? point.position : instance.place.worldFromObject().point(point.position);
    const core::Vec3<Real> normal = isInPlace ? point.normal : map.transposed(point.normal);
    placed.normal = facing<Real>(glm::normalize(normal), ray.direction, point.front);
    placed.objectNormal = point.normal;
    placed.front = point.front;
    return placed;
}

// The u axis where that is the normal in the object's own space: see SurfacePoint::tangent.
template<class Real>
core::Vec3<Real> tangentAt(const Instance& instance, const core::Vec3<Real>& objectNormal) {
    const core::Vec3<Real>& n = objectNormal;
    const Real beyondRounding(0x1p-17f), zero(0);
    const core::Mask<Real> isPole = core::abs(n.x) + core::abs(n.z) <= beyondRounding * core::abs(n.y);
    const core::Vec3<Real> east = core::select(isPole, core::Vec3<Real>(Real(1), zero, zero), {n.z, zero, -n.x});
    return instance.place.worldFromObject().vector(east);
}

// From a point off a surface to a place on a light, where it ends before it meets the light itself: t from 0 to 1.
template<class Real, template<class> class Light>
core::Ray<Real> shadowRay(const core::Vec3<Real>& start, const Light<Real>& light, const core::Vec3<Real>& target) {
    return {start, light.shadowEnd(start, target) - start, Real(1)};
}

class Scene {
public:
    std::vector<Instance> instances;
    std::vector<std::unique_ptr<const Placement::General>> placements;  // of the instances that need one
    std::vector<materials::Material> materials;
    std::vector<std::optional<materials::Interior>> interiors;  // of the materials
    Lights lights;
    std::vector<std::shared_ptr<const Polyhedron>> polyhedra;
    // What many rays at once are tested against, one after the other: the flat faces, if there are few, and some
    // objects that are about as large as all others together. The others are for the accelerator. Indices of instances.
    FaceList faces;
    std::vector<std::uint32_t> large, bodies;

    SurfacePoint surfaceAt(const core::Rayf& ray, const Hit& hit) const;
    // What is inside of a material, or null. One material's is told from another's by its address.
    const materials::Interior* interiorOf(std::uint32_t material) const {
        return interiors[material] ? &*interiors[material] : nullptr;
    }
    bool hasInteriors() const;
    std::size_t objectCount() const;  // shapes, and the triangles of meshes
    std::size_t bytes() const;
};

// Spreads out the subtree at the path `node`, lit by the area lights in it and the named lights. The node's own
// transform comes along, those above it do not. Throws core::Error for an unknown node or light, and for a scene that
// instances multiply beyond the memory of the machine.
Scene compile(const Database& database, std::string_view node, std::span<const std::string> lights);

}  // namespace gr
