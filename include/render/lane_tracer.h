// What the rays of many paths meet, all lanes at once.
#pragma once

#include "render/path_scene.h"

#include <algorithm>

namespace render {

// Surfaces where rays met them, in the world: gr::SurfacePoint in lanes.
template<class Real>
struct LaneSurface {
    Real t;  // infinity: nothing was met
    core::Vec3<Real> position;
    core::Vec3<Real> normal;  // unit length, outward
    core::Vec3<Real> shadingNormal;
    core::Vec3<Real> tangent;  // only where something is anisotropic
    Real error;
    Real material, light;  // indices; light is -1 where nothing shines
    core::Mask<Real> isSmooth;

    core::Mask<Real> isMet() const { return t < Real(core::infinity); }
};

template<class Real>
class LaneTracer {
public:
    explicit LaneTracer(const PathScene& scene) : scene_(scene) {}

    // Of the lanes that are alive.
    LaneSurface<Real> nearest(const core::Ray<Real>& ray, const core::Mask<Real>& alive,
                              gr::TraversalCounts& counts) const {
        return scene_.isInLanes ? nearestOfAll(ray, alive, counts) : nearestByAccelerator(ray, alive, counts);
    }

    // Whether anything stands between two points of the scene; for the lanes where that is asked.
    core::Mask<Real> occluded(const core::Ray<Real>& ray, const core::Mask<Real>& asked,
                              gr::TraversalCounts& counts) const {
        return scene_.isInLanes ? occludedByAny(ray, asked, counts) : occludedByAccelerator(ray, asked, counts);
    }

private:
    using Vec3 = core::Vec3<Real>;
    using Mask = core::Mask<Real>;

    static Vec3 lanes(const core::Vec3f& v) { return core::broadcast<Real>(v); }

    // Where rays meet a face's plane, and whether that is in the face.
    struct Crossing {
        Real t;
        Mask isInside;
    };
    // A face is taken a hair too large, by what rounding may move the place where the ray meets its plane: along the
    // ray by as much as t is off, which is the more the flatter it comes, and all round by as much as the way to the
    // face is. So nothing slips through between two faces. It is less than the step off a surface, or a ray that leaves
    // one along it would meet what is beyond the next edge.
    template<bool isTriangle>
    static Crossing cross(const core::Ray<Real>& ray, const Face& face) {
        const Vec3 way = lanes(face.corner) - ray.origin;
        const Vec3 normal = lanes(face.normal), toU = lanes(face.toU), toV = lanes(face.toV);
        const Real inverse = Real(1) / glm::dot(normal, ray.direction);
        const Real t = glm::dot(normal, way) * inverse;
        const Vec3 inPlane = ray.direction * t - way;
        const Real u = glm::dot(toU, inPlane), v = glm::dot(toV, inPlane);
        const Real rounding =
            (core::abs(way.x) + core::abs(way.y) + core::abs(way.z) + Real(face.extent)) * Real(0x1p-24f);
        const auto hair = [&](const Vec3& to, float reach) {
            return rounding * (core::abs(glm::dot(to, ray.direction) * inverse) + Real(reach));
        };
        const Real hairU = hair(toU, face.reachU), hairV = hair(toV, face.reachV);
        const Real half(0.5f), one(1);
        const Mask inside = isTriangle ? (u >= -hairU) & (v >= -hairV) & (u + v <= one + (hairU + hairV))
                                       : (core::abs(u - half) <= half + hairU) & (core::abs(v - half) <= half + hairV);
        return {t, inside};
    }

    template<bool isTriangle>
    static void meet(const core::Ray<Real>& ray, const std::vector<Face>& faces, float firstId, Real& t, Real& id) {
        for (const Face& face : faces) {
            const Crossing at = cross<isTriangle>(ray, face);
            const Mask isNearer = at.isInside & (at.t > Real(0)) & (at.t < t);
            t = core::select(isNearer, at.t, t);
            id = core::select(isNearer, Real(firstId), id);
            ++firstId;
        }
    }

    template<class Shape>
    static void meet(const core::Ray<Real>& ray, const std::vector<const gr::Instance*>& instances, float firstId,
                     Real& t, Real& id) {
        for (const gr::Instance* instance : instances) {
            const Real found = Shape{}.intersect(instance->place.toObject(ray));
            const Mask isNearer = found < t;
            t = core::select(isNearer, found, t);
            id = core::select(isNearer, Real(firstId), id);
            ++firstId;
        }
    }

    LaneSurface<Real> nearestOfAll(const core::Ray<Real>& ray, const Mask& alive, gr::TraversalCounts& counts) const {
        counts.tests += scene_.objectCount() * static_cast<std::uint64_t>(core::countOf(alive));
        const auto firstTriangle = static_cast<float>(scene_.faces.parallelograms.size());
        const auto firstSphere = static_cast<float>(scene_.faces.size());
        const float firstBox = firstSphere + static_cast<float>(scene_.spheres.size());
        Real t = ray.tMax, id(-1);
        meet<false>(ray, scene_.faces.parallelograms, 0, t, id);
        meet<true>(ray, scene_.faces.triangles, firstTriangle, t, id);
        meet<gr::Sphere>(ray, scene_.spheres, firstSphere, t, id);
        meet<gr::Box>(ray, scene_.boxes, firstBox, t, id);

        LaneSurface<Real> surface;
        const Mask isMet = alive & (id >= Real(0));
        surface.t = core::select(isMet, t, Real(core::infinity));
        surface.light = Real(-1);
        surface.isSmooth = Real(0) > Real(0);
        const Mask onParallelogram = isMet & (id < Real(firstTriangle));
        const Mask onTriangle = isMet & (id >= Real(firstTriangle)) & (id < Real(firstSphere));
        if (core::any(onParallelogram)) setFace<false>(surface, ray, scene_.faces.parallelograms, id, onParallelogram);
        if (core::any(onTriangle))
            setFace<true>(surface, ray, scene_.faces.triangles, id - Real(firstTriangle), onTriangle);
        setShapes<gr::Sphere>(surface, ray, scene_.spheres, id, isMet, firstSphere);
        setShapes<gr::Box>(surface, ray, scene_.boxes, id, isMet, firstBox);
        surface.shadingNormal = surface.normal;
        return surface;
    }

    template<bool isTriangle>
    void setFace(LaneSurface<Real>& surface, const core::Ray<Real>& ray, const std::vector<Face>& faces, const Real& id,
                 const Mask& here) const {
        const core::GatheredRow<Real, Face> row(faces.data(), core::toUInt(core::select(here, id, Real(0))));
        const Vec3 normal = row.vector(offsetof(Face, normal)), corner = row.vector(offsetof(Face, corner));
        Vec3 position = ray.origin + ray.direction * surface.t;
        const Real error = row.number(offsetof(Face, error)) +
                           row.number(offsetof(Face, errorPerUnit)) * core::largestComponent(position);
        // Onto the plane, off which rounding may have put the end of a long way.
        position = position - normal * glm::dot(normal, position - corner);
        // Away from the edges, so that a ray that goes on starts on the right side of the faces beyond them.
        const Vec3 inPlane = position - corner;
        const Real least = core::min(row.number(offsetof(Face, margin)) * error, Real(0.25f));
        const Real u = glm::dot(row.vector(offsetof(Face, toU)), inPlane),
                   v = glm::dot(row.vector(offsetof(Face, toV)), inPlane);
        const Real most = Real(1) - least;
        const Mask isAtEdge = here & ((core::min(u, v) < least) | ((isTriangle ? u + v : core::max(u, v)) > most));
        if (core::any(isAtEdge)) {
            const Real b1 = isTriangle ? core::max(u, least) : core::min(core::max(u, least), most);
            const Real b2 = isTriangle ? core::max(v, least) : core::min(core::max(v, least), most);
            const Real sum = isTriangle ? core::max(Real(1) - u - v, least) + b1 + b2 : Real(1);
            const Vec3 inside = corner + row.vector(offsetof(Face, edge1)) * (b1 / sum) +
                                row.vector(offsetof(Face, edge2)) * (b2 / sum);
            position = core::select(isAtEdge, inside, position);
        }
        surface.position = core::select(here, position, surface.position);
        surface.normal = core::select(here, normal, surface.normal);
        surface.error = core::select(here, error, surface.error);
        surface.material = core::select(here, row.number(offsetof(Face, material)), surface.material);
        surface.light = core::select(here, row.number(offsetof(Face, light)), surface.light);
        if (scene_.hasAnisotropy)
            surface.tangent = core::select(here, row.vector(offsetof(Face, tangent)), surface.tangent);
    }

    template<class Shape>
    void setShapes(LaneSurface<Real>& surface, const core::Ray<Real>& ray,
                   const std::vector<const gr::Instance*>& instances, const Real& id, const Mask& isMet,
                   float firstId) const {
        for (const gr::Instance* instance : instances) {
            const Mask here = isMet & (id == Real(firstId++));
            if (!core::any(here)) continue;
            const auto inObjectSpace = [&](const core::Ray<Real>& objectRay, const Vec3& margin) {
                return Shape{}.surfaceAt(objectRay, surface.t, margin);
            };
            const gr::PlacedPoint<Real> point = gr::placed(*instance, ray, surface.t, inObjectSpace);
            surface.position = core::select(here, point.position, surface.position);
            surface.normal = core::select(here, point.normal, surface.normal);
            surface.error = core::select(here, point.error, surface.error);
            surface.material = core::select(here, Real(static_cast<float>(instance->material)), surface.material);
            if (scene_.hasAnisotropy)
                surface.tangent =
                    core::select(here, gr::tangentAt<Real>(*instance, point.objectNormal), surface.tangent);
        }
    }

    template<bool isTriangle>
    static Mask isMetByAny(const core::Ray<Real>& ray, const std::vector<Face>& faces, std::size_t count, Mask isMet) {
        for (std::size_t i = 0; i < count; ++i) {
            const Crossing at = cross<isTriangle>(ray, faces[i]);
            isMet = isMet | (at.isInside & (at.t > Real(0)) & (at.t < ray.tMax));
        }
        return isMet;
    }
    template<class Shape>
    static Mask isMetByAny(const core::Ray<Real>& ray, const std::vector<const gr::Instance*>& instances, Mask isMet) {
        for (const gr::Instance* instance : instances)
            isMet = isMet | (Shape{}.intersect(instance->place.toObject(ray)) < Real(core::infinity));
        return isMet;
    }

    Mask occludedByAny(const core::Ray<Real>& ray, const Mask& asked, gr::TraversalCounts& counts) const {
        counts.tests += scene_.objectCount() * static_cast<std::uint64_t>(core::countOf(asked));
        Mask isMet = Real(0) > Real(0);
        isMet = isMetByAny<gr::Sphere>(ray, scene_.spheres, isMet);
        isMet = isMetByAny<gr::Box>(ray, scene_.boxes, isMet);
        isMet = isMetByAny<false>(ray, scene_.faces.parallelograms, scene_.faces.blockingParallelograms, isMet);
        isMet = isMetByAny<true>(ray, scene_.faces.triangles, scene_.faces.blockingTriangles, isMet);
        return isMet & asked;
    }

    static RayColumns columnsOf(const core::Ray<Real>& ray) {
        RayColumns columns;
        for (int axis = 0; axis < 3; ++axis) {
            store(ray.origin[axis], columns.origin[axis]);
            store(ray.direction[axis], columns.direction[axis]);
        }
        store(ray.tMax, columns.tMax);
        return columns;
    }
    static void store(const Real& x, float* column) {
        const core::LaneArray<Real> lane(x);
        for (int i = 0; i < core::laneCount<Real>; ++i) column[i] = lane[i];
    }
    static Real load(const float* column) {
        core::LaneArray<Real> lane;
        for (int i = 0; i < core::laneCount<Real>; ++i) lane[i] = column[i];
        return lane.real();
    }
    static Vec3 load(const float (&columns)[3][mostLanes]) {
        return {load(columns[0]), load(columns[1]), load(columns[2])};
    }

    LaneSurface<Real> nearestByAccelerator(const core::Ray<Real>& ray, const Mask& alive,
                                           gr::TraversalCounts& counts) const {
        SurfaceColumns columns{};
        const std::uint32_t lanes = core::bitsOf(alive);
        std::fill(columns.t, columns.t + mostLanes, core::infinity);
        scene_.nearest(columnsOf(ray), lanes, columns, counts);
        LaneSurface<Real> surface;
        surface.t = load(columns.t);
        surface.position = load(columns.position);
        surface.normal = load(columns.normal);
        surface.shadingNormal = load(columns.shadingNormal);
        if (scene_.hasAnisotropy) surface.tangent = load(columns.tangent);
        surface.error = load(columns.error);
        surface.material = load(columns.material);
        surface.light = load(columns.light);
        surface.isSmooth = load(columns.isSmooth) > Real(0);
        return surface;
    }

    Mask occludedByAccelerator(const core::Ray<Real>& ray, const Mask& asked, gr::TraversalCounts& counts) const {
        return core::maskOf<Real>(scene_.occluded(columnsOf(ray), core::bitsOf(asked), counts));
    }

    const PathScene& scene_;
};

}  // namespace render
