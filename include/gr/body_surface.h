// From a hit on an instance to the point of its surface, for each lane.
#pragma once

#include "gr/hit.h"
#include "gr/mesh/polyhedron_surface.h"
#include "gr/offset.h"
#include "gr/scene.h"
#include "gr/surface_point.h"

namespace gr {

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

// The surface of one instance, where rays met it. here: the lanes that did.
template<class Real>
class BodySurface {
public:
    using Mask = core::Mask<Real>;
    using Vec3 = core::Vec3<Real>;

    // instance: its index in the scene.
    BodySurface(const Scene& scene, std::uint32_t instance, const core::Ray<Real>& ray, const HitOf<Real>& hit,
                const Mask& here)
        : scene_(scene), number_(instance), instance_(scene.instances[instance]), ray_(ray), hit_(hit), here_(here) {
        // Lanes that hit something else may have the number of a triangle that this mesh has not.
        hit_.triangle = core::selectUInt<Real>(here, hit.triangle, core::UInt<Real>(0));
    }

    void set(SurfacePoint<Real>& surface, bool wantsCoordinates) const {
        std::visit(
            [&]<class S>(const S& shape) {
                // Nothing meets a CSG object but by its operands.
                if constexpr (!std::is_same_v<S, const Csg*>) set(shape, surface, wantsCoordinates);
            },
            instance_.shape);
    }

private:
    template<class Shape>
    void set(const Shape& shape, SurfacePoint<Real>& surface, bool wantsCoordinates) const {
        constexpr bool hasAxisFaces = std::remove_cvref_t<std::remove_pointer_t<Shape>>::isAxisFaced;
        const Vec3 error = instance_.template errorAt<Real>(ray_.origin + ray_.direction * hit_.t, hasAxisFaces);
        const ShapePoint<Real> own = pointOf(shape, instance_.place.toObject(ray_), marginOf(error));
        const ShapePoint<Real> point =
            instance_.isInverted ? ShapePoint<Real>{own.position, -own.normal, !own.front} : own;
        const bool isInPlace = instance_.place.isInPlace();
        const core::Transform map = instance_.place.objectFromWorld();
        const Vec3 position = isInPlace ? point.position : instance_.place.worldFromObject().point(point.position);
        const Vec3 perpendicular = isInPlace ? point.normal : map.transposed(point.normal);
        const Vec3 normal = facing<Real>(glm::normalize(perpendicular), ray_.direction, point.front);

        surface.position = core::select(here_, position, surface.position);
        surface.normal = core::select(here_, normal, surface.normal);
        surface.step = core::select(here_, offsetBeyond(error, normal), surface.step);
        surface.material = core::select(here_, Real(static_cast<float>(instance_.material)), surface.material);
        if constexpr (std::is_same_v<Shape, Square>)
            surface.light = core::select(here_, Real(static_cast<float>(shape.light)), surface.light);
        Coordinates<Real> coordinates;
        if (wantsCoordinates) coordinates = coordinatesOf(shape, own);
        Vec3 shadingNormal = normal, lifted = position;
        if constexpr (std::is_same_v<Shape, const Polyhedron*>)
            if (shape->hasNormals())
                smooth(*shape, point, normal, shadingNormal, own, lifted, coordinates, surface.isSmooth);
        surface.shadingNormal = core::select(here_, shadingNormal, surface.shadingNormal);
        surface.lifted = core::select(here_, lifted, surface.lifted);
        if (!wantsCoordinates) return;
        surface.uv.x = core::select(here_, coordinates.uv.x, surface.uv.x);
        surface.uv.y = core::select(here_, coordinates.uv.y, surface.uv.y);
        const Vec3 tangent = instance_.place.worldFromObject().vector(coordinates.tangent);
        surface.tangent = core::select(here_, tangent, surface.tangent);
        if (scene_.nodeSpaces.empty()) return;
        const Vec3 inNode = scene_.nodeSpaces[number_].point(own.position);
        surface.inNode = core::select(here_, inNode, surface.inNode);
    }

    // How far a step off the surface leads along each of the object's axes. Where the error is the same along all axes
    // no coordinate of the step is larger than (1 + sqrt(3)) / 2 times that, and rounding adds the error once more: 2.4
    // in all. Where it is not, the step has one coordinate only.
    Vec3 marginOf(const Vec3& error) const {
        if (instance_.place.isInPlace()) return error * Real(2.4f);
        const core::Transform map = instance_.place.objectFromWorld();
        const auto along = [&](const core::Vec3f& column, const Real& size) {
            return core::broadcast<Real>(glm::abs(column)) * (Real(2.4f) * size);
        };
        return along(map.x, error.x) + along(map.y, error.y) + along(map.z, error.z);
    }

    template<class Shape>
    ShapePoint<Real> pointOf(const Shape& shape, const core::Ray<Real>& ray, const Vec3& margin) const {
        if constexpr (std::is_same_v<Shape, const Polyhedron*>)
            return shape->template surfaceAt<Real>(ray, hit_, margin);
        else
            return shape.surfaceAt(ray, hit_.t, margin, isFront(shape, ray));
    }
    // Whether the ray comes from outside of a solid.
    template<class Shape>
    Mask isFront(const Shape& shape, const core::Ray<Real>& ray) const {
        if (instance_.isOperand) return core::isLess(hit_.triangle, core::UInt<Real>(HitOf<Real>::leaves));
        if constexpr (Shape::isSolid)
            return shape.level(ray.origin) > Real(0);
        else
            return Real(0) <= Real(0);
    }
    template<class Shape>
    Coordinates<Real> coordinatesOf(const Shape& shape, const ShapePoint<Real>& point) const {
        if constexpr (std::is_same_v<Shape, const Polyhedron*>)
            return shape->template coordinatesAt<Real>(point, hit_);
        else
            return shape.coordinatesAt(point);
    }

    // A mesh's own normals stand for a shape that is rounder than its faces. They change how light is reflected, never
    // which side of a face something is on. own: the point as the mesh has it, which may be inverted here.
    void smooth(const Polyhedron& mesh, const ShapePoint<Real>& point, const Vec3& faceNormal, Vec3& shadingNormal,
                const ShapePoint<Real>& own, Vec3& lifted, Coordinates<Real>& coordinates, Mask& isSmooth) const {
        const Vec3 outward = mesh.shadingNormal<Real>(hit_), given = instance_.isInverted ? -outward : outward;
        const Vec3 normal = glm::normalize(instance_.place.objectFromWorld().transposed(given));
        const Mask isGiven = here_ & (glm::dot(normal, faceNormal) > Real(0));
        if (!core::any(isGiven)) return;
        shadingNormal = core::select(isGiven, facing<Real>(normal, ray_.direction, point.front), shadingNormal);
        const Vec3 round = own.position + mesh.lift<Real>(hit_, own);
        const Vec3 placed = instance_.place.isInPlace() ? round : instance_.place.worldFromObject().point(round);
        lifted = core::select(isGiven, placed, lifted);
        coordinates.tangent = core::select(isGiven, eastOf<Real>(given), coordinates.tangent);
        isSmooth = isSmooth | isGiven;
    }

    const Scene& scene_;
    const std::uint32_t number_;
    const Instance& instance_;
    const core::Ray<Real>& ray_;
    HitOf<Real> hit_;
    const Mask& here_;
};

}  // namespace gr
