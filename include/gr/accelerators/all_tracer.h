// What the rays of many paths meet of a scene's objects where every ray is tested against every object.
#pragma once

#include "gr/csg/csg_lane_tracer.h"
#include "gr/mesh/polyhedron_surface.h"
#include "gr/scene.h"

namespace gr {

// Objects that every ray is tested against: the instances of each shape.
struct InstancesByShape {
    std::array<std::vector<std::uint32_t>, std::variant_size_v<Shape>> lists;  // as Shape lists them
    std::uint64_t count = 0;  // of shapes, and of the triangles of meshes

    InstancesByShape(const Scene& scene, Objects objects) { add(scene, objects); }
    void add(const Scene& scene, Objects objects) {
        for (const std::uint32_t i : objects) {
            const Shape& shape = scene.instances[i].shape;
            lists[shape.index()].push_back(i);
            count += partsOf(shape);
        }
    }

    // Calls f(shape, instances) for each list entry of Shape that has any.
    template<class F>
    void forEach(F&& f) const {
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            ((lists[i].empty() || (f(std::type_identity<std::variant_alternative_t<i, Shape>>(), lists[i]), true)),
             ...);
        }
        (std::make_index_sequence<std::variant_size_v<Shape>>());
    }
};

template<class Real>
class AllTracer {
public:
    using Mask = core::Mask<Real>;
    using UInt = core::UInt<Real>;

    AllTracer(const Scene& scene, const InstancesByShape& bodies) : scene_(scene), bodies_(bodies) {}

    // Replaces hits by what comes before them, of the lanes that are alive.
    void nearest(const core::Ray<Real>& ray, const Mask& alive, HitOf<Real>& nearest) const {
        bodies_.forEach([&]<class S>(std::type_identity<S>, const std::vector<std::uint32_t>& instances) {
            for (const std::uint32_t i : instances) {
                const core::Ray<Real> objectRay = scene_.instances[i].place.toObject(ray);
                if constexpr (std::is_same_v<S, const Polyhedron*>)
                    nearestOf(objectRay, i, *std::get<S>(scene_.instances[i].shape), nearest);
                else if constexpr (std::is_same_v<S, const Csg*>)
                    nearestOf(ray, alive, *std::get<S>(scene_.instances[i].shape), nearest);
                else
                    offer(std::get<S>(scene_.instances[i].shape).intersect(objectRay), i, nearest);
            }
        });
    }

    // For the lanes where that is asked; what it says of others means nothing.
    Mask occluded(const core::Ray<Real>& ray, const Mask& asked) const {
        Mask isMet = Real(0) > Real(0);
        bodies_.forEach([&]<class S>(std::type_identity<S>, const std::vector<std::uint32_t>& instances) {
            for (const std::uint32_t i : instances) {
                const core::Ray<Real> objectRay = scene_.instances[i].place.toObject(ray);
                if constexpr (std::is_same_v<S, const Polyhedron*>)
                    isMet = isMet | isMetBy(objectRay, *std::get<S>(scene_.instances[i].shape));
                else if constexpr (std::is_same_v<S, const Csg*>)
                    isMet = isMet | isMetBy(ray, asked & !isMet, *std::get<S>(scene_.instances[i].shape));
                else
                    isMet =
                        isMet | (std::get<S>(scene_.instances[i].shape).intersect(objectRay) < Real(core::infinity));
            }
        });
        return isMet;
    }

private:
    // Where two surfaces coincide the one made first is hit: see Hit::isBefore.
    static Mask isBefore(const Real& t, const UInt& instance, const HitOf<Real>& nearest) {
        const Mask isTie = (t == nearest.t) & (t < Real(core::infinity));
        if (!core::any(isTie)) return t < nearest.t;
        return (t < nearest.t) | (isTie & core::isLess(instance, nearest.instance));
    }

    static void offer(const Real& t, std::uint32_t instance, HitOf<Real>& nearest) {
        const Mask isNearer = isBefore(t, UInt(instance), nearest);
        if (core::any(isNearer)) replace(isNearer, {t, UInt(instance)}, nearest);
    }
    static void replace(const Mask& here, const HitOf<Real>& found, HitOf<Real>& nearest) {
        nearest.t = core::select(here, found.t, nearest.t);
        nearest.b1 = core::select(here, found.b1, nearest.b1);
        nearest.b2 = core::select(here, found.b2, nearest.b2);
        nearest.instance = core::selectUInt<Real>(here, found.instance, nearest.instance);
        nearest.triangle = core::selectUInt<Real>(here, found.triangle, nearest.triangle);
    }

    void nearestOf(const core::Ray<Real>& ray, const Mask& alive, const Csg& csg, HitOf<Real>& nearest) const {
        const core::Ray<Real> endless{ray.origin, ray.direction, Real(core::infinity)};
        const HitOf<Real> found = CsgLaneTracer<Real>(scene_, csg).first(endless, alive, nearest.t);
        const Mask isNearer = isBefore(found.t, found.instance, nearest);
        if (core::any(isNearer)) replace(isNearer, found, nearest);
    }
    Mask isMetBy(const core::Ray<Real>& ray, const Mask& asked, const Csg& csg) const {
        return CsgLaneTracer<Real>(scene_, csg).first(ray, asked, ray.tMax).t < Real(core::infinity);
    }

    // In a mesh the triangles come in their order, so that of equal ones the first stays.
    static void nearestOf(const core::Ray<Real>& ray, std::uint32_t instance, const Polyhedron& mesh,
                          HitOf<Real>& nearest) {
        forEachTriangle(ray, mesh, [&](std::uint32_t triangle, const TriangleHit<Real>& found) {
            replace(isBefore(found.t, UInt(instance), nearest),
                    {found.t, UInt(instance), UInt(triangle), found.b1, found.b2}, nearest);
        });
    }
    static Mask isMetBy(const core::Ray<Real>& ray, const Polyhedron& mesh) {
        Mask isMet = Real(0) > Real(0);
        forEachTriangle(ray, mesh, [&](std::uint32_t, const TriangleHit<Real>& found) {
            isMet = isMet | (found.t < Real(core::infinity));
        });
        return isMet;
    }

    // Calls found(triangle, hit) for those that any lane's ray goes through. The exact areas are asked only there.
    template<class Found>
    static void forEachTriangle(const core::Ray<Real>& ray, const Polyhedron& mesh, Found&& found) {
        const TriangleRay<Real> meshRay(ray);
        const auto count = static_cast<std::uint32_t>(mesh.triangleCount());
        for (std::uint32_t i = 0; i < count; ++i) {
            const auto corner = [&](int k) { return meshRay.axes.permute(core::broadcast<Real>(mesh.vertex(i, k))); };
            const core::Vec3<Real> a = corner(0), b = corner(1), c = corner(2);
            if (!core::any(meshRay.cross(a, b, c).inside)) continue;
            found(i, meshRay.hit(meshRay.exactCross(a, b, c), a, b, c));
        }
    }

    const Scene& scene_;
    const InstancesByShape& bodies_;
};

}  // namespace gr
