// What one ray meets of a mesh in a tree. To be compiled for each instruction set: Lanes are 4 or 8 floats, the boxes
// or triangles that it is tested against at once.
#pragma once

#include "gr/accelerators/object_pack.h"
#include "gr/accelerators/wide_tree_walk.h"

namespace gr {

// A ray in the mesh's own space, made ready for its tree and for its triangles.
template<class Lanes>
struct MeshRay {
    BoxRay<Lanes> boxes;
    TriangleRay<Lanes, UniformAxes> triangles;
};

// Calls offer(lane, t) for those of the hits that may come before the nearest.
template<class Lanes, class Offer>
void forEachNear(const Lanes& found, const float& nearest, Offer&& offer) {
    const std::uint32_t near = core::bitsOf(found <= Lanes(nearest));
    if (near == 0) return;
    const core::LaneArray<Lanes> t(found);
    core::forEachLane(near, [&](int lane) { offer(lane, t[lane]); });
}

template<class Lanes>
class MeshTracer {
public:
    MeshTracer(const MeshPack& mesh, TraversalCounts& counts) : mesh_(mesh), counts_(counts) {}

    // Replaces `nearest` by what comes before it. Its t must not be beyond the ray's end.
    void nearest(const MeshRay<Lanes>& ray, Hit& nearest) const {
        walkTree(mesh_.tree->root(), ray.boxes, nearest.t, [&](const void* at) {
            const auto& leaf = *static_cast<const TriangleLeaf*>(at);
            counts_.tests += treeWidth;
            for (int first = 0; first < treeWidth; first += width)
                leaf.triangles.intersect(ray.triangles, first, [&](const TriangleHit<Lanes>& found) {
                    forEachNear(found.t, nearest.t, [&](int lane, float t) {
                        const core::LaneArray<Lanes> b1(found.b1), b2(found.b2);
                        const Hit hit{t, mesh_.instance[0], leaf.triangle[first + lane], b1[lane], b2[lane]};
                        if (t < core::infinity && hit.isBefore(nearest)) nearest = hit;
                    });
                });
            return false;
        });
    }

    // Whether the ray meets it before `end`, which is its own.
    bool occluded(const MeshRay<Lanes>& ray, float end) const {
        return walkTree(mesh_.tree->root(), ray.boxes, end, [&](const void* at) {
            counts_.tests += treeWidth;
            return isLeafMet(ray.triangles, *static_cast<const TriangleLeaf*>(at));
        });
    }

private:
    static constexpr int width = static_cast<int>(Lanes::size);

    static bool isLeafMet(const TriangleRay<Lanes, UniformAxes>& ray, const TriangleLeaf& leaf) {
        bool isMet = false;
        for (int first = 0; first < treeWidth && !isMet; first += width)
            leaf.triangles.intersect(ray, first, [&](const TriangleHit<Lanes>& found) {
                isMet = core::any(found.t < Lanes(core::infinity));
            });
        return isMet;
    }

    const MeshPack& mesh_;
    TraversalCounts& counts_;
};

}  // namespace gr
