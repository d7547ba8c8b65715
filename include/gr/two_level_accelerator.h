// The report's two levels (section 5.3): an index over the whole scene, and one for each polyhedron that is large
// enough to want its own, which all its instances share.
#pragma once

#include "gr/pack.h"
#include "gr/scene.h"

#include <algorithm>
#include <functional>
#include <unordered_map>

namespace gr {

// Index: whatever finds the items near a ray by their bounds:
//     walk(ray, nearest, counts, visit)
// calls visit(item) for them until it returns true, or nothing nearer than `nearest`, which visit may lower, can
// follow. Index::trianglesPerItem of a mesh, one behind the other, are an item.
template<class Index>
class TwoLevelAccelerator : public Accelerator {
public:
    using BoundsOf = std::function<core::Bounds(std::uint32_t)>;
    // Of the items 0 to count - 1. The bounds hold every point at which an item may be reported to be hit by a ray that
    // starts at the origin; one that starts or hits at distance x from there may be off by errorPerUnit * x more.
    using Make = std::function<std::unique_ptr<Index>(std::uint32_t count, BoundsOf boundsOf, float errorPerUnit)>;

    TwoLevelAccelerator(const Scene& scene, const Make& make) : scene_(scene) {
        objects_ = make(
            static_cast<std::uint32_t>(scene.instances.size()),
            [&scene](std::uint32_t i) { return scene.instances[i].bounds(); }, largestErrorPerUnit());
        for (const auto& polyhedron : scene.polyhedra)
            if (polyhedron->triangleCount() > mostTrianglesWithoutIndex)
                meshes_.emplace(polyhedron.get(), make((triangleCount(*polyhedron) + perItem - 1) / perItem,
                                                       triangleBounds(*polyhedron), triangleErrorPerUnit));
    }

    std::optional<Hit> intersect(const core::Rayf& ray, TraversalCounts& counts) const override {
        Hit nearest;
        float reach = ray.tMax;
        objects_->walk(ray, reach, counts, [&](std::uint32_t i) {
            ++counts.tests;
            const Instance& instance = scene_.instances[i];
            const core::Rayf objectRay = instance.toObject(ray);
            const auto test = [&](const auto& shape) { intersectShape(shape, objectRay, i, nearest, reach, counts); };
            std::visit(test, instance.shape);
            return false;
        });
        if (nearest.t == core::infinity) return std::nullopt;
        return nearest;
    }

    bool occluded(const core::Rayf& ray, TraversalCounts& counts) const override {
        bool isMet = false;
        objects_->walk(ray, ray.tMax, counts, [&](std::uint32_t i) {
            ++counts.tests;
            const Instance& instance = scene_.instances[i];
            const core::Rayf objectRay = instance.toObject(ray);
            const auto test = [&](const auto& shape) { return isHit(shape, objectRay, counts); };
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
    static constexpr std::uint32_t perItem = Index::trianglesPerItem;

    static std::uint32_t triangleCount(const Polyhedron& polyhedron) {
        return static_cast<std::uint32_t>(polyhedron.triangleCount());
    }

    // Calls visit(triangle) for those of an item until it returns true, and returns whether it did.
    template<class Visit>
    static bool forEachTriangle(const Polyhedron& polyhedron, std::uint32_t item, Visit&& visit) {
        const std::uint32_t end = std::min((item + 1) * perItem, triangleCount(polyhedron));
        for (std::uint32_t triangle = item * perItem; triangle < end; ++triangle)
            if (visit(triangle)) return true;
        return false;
    }

    float largestErrorPerUnit() const {
        float largest = 0;
        for (const Instance& instance : scene_.instances) largest = std::max(largest, instance.errorPerUnit);
        return 2 * largest + 8 * unitRoundoff;
    }

    static BoundsOf triangleBounds(const Polyhedron& polyhedron) {
        return [&polyhedron](std::uint32_t item) {
            core::Bounds bounds;
            forEachTriangle(polyhedron, item, [&](std::uint32_t triangle) {
                for (int corner = 0; corner < 3; ++corner) bounds.include(polyhedron.vertex(triangle, corner));
                return false;
            });
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
        if (mesh == meshes_.end()) {
            polyhedron->intersect(PackRay(ray), instance, nearest);
            reach = std::min(reach, nearest.t);
            return;
        }
        const TriangleRay<float> triangleRay(ray);
        const auto test = [&](std::uint32_t triangle) {
            ++counts.tests;
            const TriangleHit<float> found = polyhedron->intersect(triangleRay, triangle);
            offer({found.t, instance, triangle, found.b1, found.b2}, nearest, reach);
            return false;
        };
        mesh->second->walk(ray, reach, counts,
                           [&](std::uint32_t item) { return forEachTriangle(*polyhedron, item, test); });
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
        if (mesh == meshes_.end()) return polyhedron->occluded(PackRay(ray));
        const TriangleRay<float> triangleRay(ray);
        bool isMet = false;
        const auto test = [&](std::uint32_t triangle) {
            ++counts.tests;
            return polyhedron->intersect(triangleRay, triangle).t < core::infinity;
        };
        mesh->second->walk(ray, ray.tMax, counts,
                           [&](std::uint32_t item) { return isMet = forEachTriangle(*polyhedron, item, test); });
        return isMet;
    }

    const Scene& scene_;
    std::unique_ptr<Index> objects_;
    std::unordered_map<const Polyhedron*, std::unique_ptr<Index>> meshes_;
};

}  // namespace gr
