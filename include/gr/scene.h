// What is rendered: the scene graph spread out into a flat list, in world space, never changed again.
#pragma once

#include "gr/accelerators/accelerator.h"
#include "gr/accelerators/face_list.h"
#include "gr/hit.h"
#include "gr/light.h"
#include "gr/placement.h"
#include "gr/shape.h"
#include "gr/surface_point.h"
#include "materials/material.h"

#include <memory>
#include <optional>
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
    float errorPerUnit() const {
        const float condition = place.condition();
        // What has no end has its extent from the point, there and back.
        const float ofExtent = isEndless(shape) ? (48 + 16 * condition) * condition : 0;
        return 0x1p-24f * (2 + 10 * condition + ofExtent);
    }

    core::Bounds bounds() const;  // in the world, of every point at which a ray may be reported to hit it
};

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
    // objects that are about as large as all others together, or endless. The others are for the accelerator. Indices
    // of instances.
    FaceList faces;
    std::vector<std::uint32_t> large, bodies;

    // Where the ray met what an accelerator over all instances found. wantsCoordinates: uv and tangent.
    SurfacePoint<float> surfaceAt(const core::Rayf& ray, const Hit& hit, bool wantsCoordinates = true) const;
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
