// What is rendered: the scene graph spread out into a flat list, in world space, never changed again.
#pragma once

#include "gr/accelerator.h"
#include "gr/light.h"
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
    // The plane moves by the support of the error's cube in the direction of `side`.
    static core::Vec3f offsetFrom(const core::Vec3f& position, const core::Vec3f& side, float error) {
        return position + side * (error * (std::abs(side.x) + std::abs(side.y) + std::abs(side.z)));
    }
};

class Scene {
public:
    std::vector<Instance> instances;
    std::vector<std::unique_ptr<const Placement::General>> placements;  // of the instances that need one
    std::vector<materials::Material> materials;
    std::vector<AreaLight> areaLights;
    std::vector<PointLight> pointLights;
    std::vector<std::shared_ptr<const Polyhedron>> polyhedra;

    SurfacePoint surfaceAt(const core::Rayf& ray, const Hit& hit) const;
    // From a point off a surface to a place on an area light, a hair before it: t from 0 to 1.
    core::Rayf shadowRay(const core::Vec3f& start, const AreaLight& light, const core::Vec3f& target) const;
    std::size_t objectCount() const;  // shapes, and the triangles of meshes
    std::size_t bytes() const;
};

// Spreads out the subtree at the path `node`, lit by the area lights in it and the named point lights. The node's own
// transform comes along, those above it do not. Throws core::Error for an unknown node or light, and for a scene that
// instances multiply beyond the memory of the machine.
Scene compile(const Database& database, std::string_view node, std::span<const std::string> lights);

}  // namespace gr
