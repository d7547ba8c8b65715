// What one ray meets in the trees. To be compiled for each instruction set: Lanes are 4 or 8 floats, the boxes,
// triangles or shapes that it is tested against at once.
#pragma once

#include "gr/accelerators/mesh_tracer.h"
#include "gr/accelerators/object_tree.h"
#include "gr/csg/csg_tracer.h"

namespace gr {

template<class Lanes>
class TreeTracer {
public:
    TreeTracer(const Scene& scene, const ObjectTree& tree, TraversalCounts& counts)
        : scene_(scene), objects_(tree.objects()), counts_(counts) {}

    // Replaces `nearest` by what comes before it. Its t must not be beyond the ray's end.
    void nearest(const core::Rayf& ray, Hit& found) const { nearest(ray, objectsRay(ray), found); }
    bool occluded(const core::Rayf& ray) const { return occluded(ray, objectsRay(ray)); }

    // boxRay: the ray made ready for the tree over the objects.
    void nearest(const core::Rayf& ray, const BoxRay<Lanes>& boxRay, Hit& nearest) const {
        forEachPack(boxRay, nearest.t, [&](const auto& pack) {
            if constexpr (std::is_same_v<decltype(pack), const MeshPack&>)
                MeshTracer<Lanes>(pack, counts_).nearest(meshRay(ray, pack), nearest);
            else if constexpr (std::is_same_v<decltype(pack), const CsgPack&>)
                CsgTracer<Lanes>(scene_, *pack.csg, counts_).nearest(ray, nearest);
            else
                nearestOf(everywhere(ray), pack, nearest);
            return false;
        });
    }

    bool occluded(const core::Rayf& ray, const BoxRay<Lanes>& boxRay) const {
        return forEachPack(boxRay, ray.tMax, [&](const auto& pack) {
            if constexpr (std::is_same_v<decltype(pack), const MeshPack&>)
                return MeshTracer<Lanes>(pack, counts_).occluded(meshRay(ray, pack), ray.tMax);
            else if constexpr (std::is_same_v<decltype(pack), const CsgPack&>)
                return CsgTracer<Lanes>(scene_, *pack.csg, counts_).occluded(ray);
            else
                return isAnyMet(everywhere(ray), pack);
        });
    }

private:
    static constexpr int width = static_cast<int>(Lanes::size);

    static core::Ray<Lanes> everywhere(const core::Rayf& ray) {
        return {core::broadcast<Lanes>(ray.origin), core::broadcast<Lanes>(ray.direction), Lanes(ray.tMax)};
    }

    BoxRay<Lanes> objectsRay(const core::Rayf& ray) const { return boxRayFor<Lanes>(objects_, ReadyRay(ray)); }

    static MeshRay<Lanes> meshRay(const core::Rayf& worldRay, const MeshPack& mesh) {
        const core::Rayf ray = mesh.place.toObject(worldRay);
        return {boxRayFor<Lanes>(*mesh.tree, ReadyRay(ray)), TriangleRay<Lanes, UniformAxes>(TriangleRay<float>(ray))};
    }

    // Calls visit(pack) for the packs near the ray, until it returns true; returns whether it did.
    template<class Visit>
    bool forEachPack(const BoxRay<Lanes>& ray, const float& nearest, Visit&& visit) const {
        const auto visitLeaf = [&](const void* leaf) {
            const auto& pack = *static_cast<const ObjectPack*>(leaf);
            counts_.tests += pack.count;
            return visitPack(pack, visit);
        };
        return walkTree(objects_.root(), ray, nearest, visitLeaf);
    }

    template<class Pack>
    static void nearestOf(const core::Ray<Lanes>& ray, const Pack& pack, Hit& nearest) {
        for (int first = 0; first < static_cast<int>(pack.count); first += width)
            forEachNear(pack.template intersect<Lanes>(ray, first), nearest.t, [&](int lane, float t) {
                const Hit hit{t, pack.instance[first + lane]};
                if (t < core::infinity && hit.isBefore(nearest)) nearest = hit;
            });
    }
    template<class Pack>
    static bool isAnyMet(const core::Ray<Lanes>& ray, const Pack& pack) {
        for (int first = 0; first < static_cast<int>(pack.count); first += width)
            if (core::any(pack.template intersect<Lanes>(ray, first) < Lanes(core::infinity))) return true;
        return false;
    }

    const Scene& scene_;
    const WideTree& objects_;
    TraversalCounts& counts_;
};

}  // namespace gr
