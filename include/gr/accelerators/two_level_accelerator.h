// The report's two levels (section 5.3): an index over the whole scene, and one for each polyhedron that is large
// enough to want its own, which all its instances share.
#pragma once

#include "gr/csg/csg_tracer.h"
#include "gr/mesh/pack.h"
#include "gr/scene.h"

#include <algorithm>
#include <functional>
#include <unordered_map>

namespace gr {

// Index: whatever finds the items near a ray by their bounds:
//     walk(ray, nearest, counts, visit)
// calls visit(item) for them until it returns true, or nothing nearer than `nearest`, which visit may lower, can
// follow. The items of a mesh are its packs of triangles.
template<class Index>
class TwoLevelAccelerator : public Accelerator {
public:
    using BoundsOf = std::function<core::Bounds(std::uint32_t)>;
    // Of the items 0 to count - 1. The bounds hold every point at which an item may be reported to be hit by a ray that
    // starts at the origin; one that starts or hits at distance x from there may be off by errorPerUnit * x more.
    using Make = std::function<std::unique_ptr<Index>(std::uint32_t count, BoundsOf boundsOf, float errorPerUnit)>;

    TwoLevelAccelerator(const Scene& scene, Objects objects, const Make& make)
        : scene_(scene), instances_(objects.begin(), objects.end()) {
        objects_ = make(
            static_cast<std::uint32_t>(objects.size()),
            [&](std::uint32_t i) { return scene.instances[objects[i]].bounds(); }, largestErrorPerUnit());
        for (const std::uint32_t i : objects) {
            const auto* mesh = std::get_if<const Polyhedron*>(&scene.instances[i].shape);
            if (mesh != nullptr && (*mesh)->triangleCount() > mostTrianglesWithoutIndex && !meshes_.contains(*mesh))
                meshes_.emplace(*mesh, make(static_cast<std::uint32_t>((*mesh)->packCount()), packBounds(**mesh),
                                            triangleErrorPerUnit));
        }
    }

    std::optional<Hit> intersect(const core::Rayf& ray, TraversalCounts& counts) const override {
        Hit nearest;
        float reach = ray.tMax;
        objects_->walk(ray, reach, counts, [&](std::uint32_t item) {
            ++counts.tests;
            const std::uint32_t i = instances_[item];
            const Instance& instance = scene_.instances[i];
            const core::Rayf objectRay = instance.place.toObject(ray);
            const auto test = [&]<class S>(const S& shape) {
                if constexpr (std::is_same_v<S, const Csg*>)
                    CsgTracer<PackLanes>(scene_, *shape, counts).nearest(ray, nearest);
                else
                    intersectShape(shape, objectRay, i, nearest, reach, counts);
                reach = std::min(reach, nearest.t);
            };
            std::visit(test, instance.shape);
            return false;
        });
        if (nearest.t == core::infinity) return std::nullopt;
        return nearest;
    }

    bool occluded(const core::Rayf& ray, TraversalCounts& counts) const override {
        bool isMet = false;
        objects_->walk(ray, ray.tMax, counts, [&](std::uint32_t item) {
            ++counts.tests;
            const Instance& instance = scene_.instances[instances_[item]];
            const core::Rayf objectRay = instance.place.toObject(ray);
            const auto test = [&]<class S>(const S& shape) {
                if constexpr (std::is_same_v<S, const Csg*>)
                    return CsgTracer<PackLanes>(scene_, *shape, counts).occluded(ray);
                else
                    return isHit(shape, objectRay, counts);
            };
            isMet = std::visit(test, instance.shape);
            return isMet;
        });
        return isMet;
    }

protected:
    const Index& objects() const { return *objects_; }
    const std::unordered_map<const Polyhedron*, std::unique_ptr<Index>>& meshes() const { return meshes_; }

private:
    static constexpr float unitRoundoff = 0x1p-24f;
    static constexpr float triangleErrorPerUnit = 64 * unitRoundoff;
    static constexpr std::size_t mostTrianglesWithoutIndex = 16;

    float largestErrorPerUnit() const {
        float largest = 0;
        for (const Instance& instance : scene_.instances) largest = std::max(largest, instance.errorPerUnit());
        return 2 * largest + 8 * unitRoundoff;
    }

    static BoundsOf packBounds(const Polyhedron& polyhedron) {
        return [&polyhedron](std::uint32_t pack) {
            const core::Bounds bounds = polyhedron.packBounds(pack);
            return bounds.widened(triangleErrorPerUnit * bounds.reach());
        };
    }

    template<class S>
    static void intersectShape(const S& shape, const core::Rayf& ray, std::uint32_t instance, Hit& nearest,
                               float& reach, TraversalCounts&) {
        offer({shape.intersect(ray), instance}, nearest, reach);
    }
    void intersectShape(const Polyhedron* polyhedron, const core::Rayf& ray, std::uint32_t instance, Hit& nearest,
                        float& reach, TraversalCounts& counts) const {
        const auto mesh = meshes_.find(polyhedron);
        const PackRay packRay(ray);
        if (mesh == meshes_.end()) {
            counts.tests += polyhedron->triangleCount();
            polyhedron->intersect(packRay, instance, nearest);
            reach = std::min(reach, nearest.t);
            return;
        }
        mesh->second->walk(ray, reach, counts, [&](std::uint32_t pack) {
            counts.tests += packWidth;
            polyhedron->intersect(packRay, pack, instance, nearest);
            reach = std::min(reach, nearest.t);
            return false;
        });
    }

    static void offer(const Hit& hit, Hit& nearest, float& reach) {
        if (!hit.isBefore(nearest)) return;
        nearest = hit;
        reach = hit.t;
    }

    template<class S>
    static bool isHit(const S& shape, const core::Rayf& ray, TraversalCounts&) {
        return shape.intersect(ray) < core::infinity;
    }
    bool isHit(const Polyhedron* polyhedron, const core::Rayf& ray, TraversalCounts& counts) const {
        const auto mesh = meshes_.find(polyhedron);
        const PackRay packRay(ray);
        if (mesh == meshes_.end()) {
            counts.tests += polyhedron->triangleCount();
            return polyhedron->occluded(packRay);
        }
        bool isMet = false;
        mesh->second->walk(ray, ray.tMax, counts, [&](std::uint32_t pack) {
            counts.tests += packWidth;
            return isMet = polyhedron->occluded(packRay, pack);
        });
        return isMet;
    }

    const Scene& scene_;
    std::vector<std::uint32_t> instances_;  // that the items of objects_ are
    std::unique_ptr<Index> objects_;
    std::unordered_map<const Polyhedron*, std::unique_ptr<Index>> meshes_;
};

}  // namespace gr
