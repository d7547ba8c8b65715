// What is rendered: the scene graph spread out into a flat list, in world space but for its origin, never changed
// again.
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
#include <string>
#include <vector>

namespace gr {

class Database;

// A shape at one place. Nodes' sizes and positions are part of the placement. The operands of a CSG object are
// instances, too, and what a ray is told to have met of it is one of these.
struct Instance {
    Placement place;
    Shape shape;
    std::uint32_t material : 30 = 0;  // index into Scene::materials; of a CSG object what is inside of it
    std::uint32_t isOperand : 1 = 0;  // of a CSG object: rays meet it only by way of that
    std::uint32_t isInverted : 1 = 0;  // what is outside of it is what the CSG object holds
    // How far single precision may put a point of the surface off its true place along any axis, there and back from
    // object space: error + errorPerUnit() * the point's largest world coordinate.
    float error = 0;
    float errorPerUnit() const {
        const float condition = place.condition();
        // What has no end has its extent from the point, there and back.
        const float ofExtent = isEndless(shape) ? (48 + 16 * condition) * condition : 0;
        return 0x1p-24f * (2 + 10 * condition + ofExtent);
    }

    // The same along each of the world's axes, of a point of the surface: much less, where faces lie across them.
    template<class Real>
    core::Vec3<Real> errorAt(const core::Vec3<Real>& point) const {
        return errorAt<Real>(point, isAxisFaced(shape));
    }
    // For who knows what the shape is: of many rays that ask, none has to look.
    template<class Real>
    core::Vec3<Real> errorAt(const core::Vec3<Real>& point, bool hasAxisFaces) const {
        if (hasAxisFaces && !place.isGeneral() && !isOperand) return alignedErrorAt(point);
        return core::Vec3<Real>(Real(error) + Real(errorPerUnit()) * core::largestComponent(point));
    }

    core::Bounds bounds() const;  // in the world, of every point at which a ray may be reported to hit it

private:
    // Of world = scale * object + translation, axis by axis, where the face's own coordinate is known exactly. In units
    // of 2^-24, the relative size of a rounding, with s = |scale * object|, t = |translation| and x = |world|:
    //   s + s + t + x    there: scale, its product, translation and sum are rounded,
    //   x                in the step off the surface,
    //   x + x + t + s    and back likewise.
    // No more is asked for: on which side of the face a ray starts is told by one sign, and one along the face has
    // exactly 0 for its direction across it. Half as much again is kept, for second order and for the edges' sake.
    template<class Real>
    core::Vec3<Real> alignedErrorAt(const core::Vec3<Real>& point) const {
        const AlignedMap map = place.alignedWorldFromObject();
        const core::Vec3f object(isEndless(shape) ? 0.f : 1.f);  // the largest coordinates, but for the face's own
        const core::Vec3f fixed = (glm::abs(map.scale) * object * 4.5f + glm::abs(map.translation) * 3.f) * 0x1p-24f;
        core::Vec3<Real> error;
        for (int axis = 0; axis < 3; ++axis)
            error[axis] = Real(fixed[axis]) + core::abs(point[axis]) * Real(6 * 0x1p-24f);
        return error;
    }
};

// From a point off a surface to a place on a light, where it ends before it meets the light itself: t from 0 to 1.
// Towards an endless light, of which the target is a direction, it has no end.
template<class Real, template<class> class Light>
core::Ray<Real> shadowRay(const core::Vec3<Real>& start, const Light<Real>& light, const core::Vec3<Real>& target) {
    if constexpr (Light<Real>::isEndless)
        return {start, target};
    else
        return {start, light.shadowEnd(start, target) - start, Real(1)};
}

class Scene {
public:
    std::vector<Instance> instances;
    std::vector<std::unique_ptr<const Placement::General>> placements;  // of the instances that need one
    // From each instance's own space to that of the node that made it. Empty where no material has a texture.
    std::vector<core::Transform> nodeSpaces;
    std::vector<materials::Material> materials;
    std::vector<std::optional<materials::Interior>> interiors;  // of the materials
    std::vector<std::vector<materials::TextureUse>> textures;  // of the materials; empty where none has any
    Lights lights;
    std::shared_ptr<const SkyGrid> sky;  // of the light that is one, or null
    std::vector<std::shared_ptr<const Polyhedron>> polyhedra;
    std::vector<std::unique_ptr<Csg>> csgs;
    std::shared_ptr<MeshTrees> operandMeshes;  // in them
    glm::dvec3 origin{0};  // in the world; all other coordinates here are relative to it
    std::vector<std::string> warnings;  // of what single precision cannot show, each a text for the user
    // What many rays at once are tested against, one after the other: the flat faces, if there are few, and some
    // objects that are about as large as all others together, or endless. The others are for the accelerator. Indices
    // of instances.
    FaceList faces;
    std::vector<std::uint32_t> large, bodies;

    // Where the ray met what an accelerator over all instances found. wantsCoordinates: uv, tangent and inNode.
    SurfacePoint<float> surfaceAt(const core::Rayf& ray, const Hit& hit, bool wantsCoordinates = true) const;
    // What is inside of a material, or null. One material's is told from another's by its address.
    const materials::Interior* interiorOf(std::uint32_t material) const {
        return interiors[material] ? &*interiors[material] : nullptr;
    }
    bool hasInteriors() const;
    bool hasTextures() const { return !textures.empty(); }
    std::size_t objectCount() const;  // shapes, and the triangles of meshes
    std::size_t bytes() const;
};

// Where a scene's own origin is: at the world's, so that numbers that a script gives stay as they are; or, if the scene
// lies farther away from there than it is large, in its middle, so that no digits are spent on telling how far.
enum class Origin { isTheWorlds, isNear };

// A sky round the scene, or none: turned by so many degrees about +y, counterclockwise seen from above.
struct Sky {
    std::shared_ptr<const SkyGrid> grid;
    double degrees = 0;
};

// Spreads out the subtree at the path `node`, lit by the area lights in it, the named lights and the sky. The node's
// own transform comes along, those above it do not. Throws core::Error for an unknown node or light, and for a scene
// that instances multiply beyond the memory of the machine.
Scene compile(const Database& database, std::string_view node, std::span<const std::string> lights,
              Origin origin = Origin::isTheWorlds, const Sky& sky = {});

}  // namespace gr
