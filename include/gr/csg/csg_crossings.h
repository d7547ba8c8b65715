// Where a ray goes into the operands of a CSG object and out of them. To be compiled for each instruction set: Lanes
// are 4 or 8 floats, the boxes, triangles or shapes that the ray is tested against at once.
#pragma once

#include "gr/accelerators/mesh_tracer.h"
#include "gr/accelerators/object_tree.h"
#include "gr/mesh/edge_side.h"

#include <algorithm>

namespace gr {

// Of one operand. At t = 0 are those that a ray has before it starts, as it is inside.
struct CsgCrossing {
    Hit hit;
    bool enters;

    // Where several are at one place the operand made first comes first, and a part that has no length begins before it
    // ends.
    bool isBefore(const CsgCrossing& other) const {
        if (hit.t != other.hit.t) return hit.t < other.hit.t;
        if (hit.instance != other.hit.instance) return hit.instance < other.hit.instance;
        return enters && !other.enters;
    }
};

// Adds the ends of a part of the line that an operand holds, if it is ahead.
inline void addSpan(float enter, float leave, std::uint32_t instance, std::vector<CsgCrossing>& crossings) {
    crossings.push_back({{std::max(enter, 0.f), instance}, true});
    if (leave < core::infinity) crossings.push_back({{std::max(enter, leave), instance, Hit::leaves}, false});
}

inline void sortCrossings(std::vector<CsgCrossing>& crossings) {
    // Most rays have a few.
    constexpr std::size_t few = 12;
    if (crossings.size() <= few) {
        for (std::size_t i = 1; i < crossings.size(); ++i)
            for (std::size_t k = i; k > 0 && crossings[k].isBefore(crossings[k - 1]); --k)
                std::swap(crossings[k], crossings[k - 1]);
        return;
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const CsgCrossing& a, const CsgCrossing& b) { return a.isBefore(b); });
}

template<class Lanes>
class CsgCrossings {
public:
    CsgCrossings(const Scene& scene, const Csg& csg, TraversalCounts& counts, std::vector<CsgCrossing>& found)
        : scene_(scene), csg_(csg), counts_(counts), found_(found) {}

    // Puts those that lie ahead into `found`, in their order; beyond `end` they need not be there.
    void find(const core::Rayf& ray, float end) {
        found_.clear();
        const WideTree& tree = csg_.bounded().objects();
        const BoxRay<Lanes> boxRay = boxRayFor<Lanes>(tree, ReadyRay(ray));
        const core::Ray<Lanes> everywhere{core::broadcast<Lanes>(ray.origin), core::broadcast<Lanes>(ray.direction),
                                          Lanes(core::infinity)};
        walkTree(tree.root(), boxRay, end, [&](const void* leaf) {
            const auto& pack = *static_cast<const ObjectPack*>(leaf);
            counts_.tests += pack.count;
            return visitPack(pack, [&](const auto& one) {
                add(everywhere, ray, one);
                return false;
            });
        });
        // What has no end matters only to what has one.
        if (found_.empty()) return;
        for (const std::uint32_t i : csg_.endless()) addEndless(ray, i);
        sortCrossings(found_);
    }

private:
    static constexpr int width = static_cast<int>(Lanes::size);

    void add(const core::Ray<Lanes>& ray, const core::Rayf&, const auto& pack) {
        using Pack = std::remove_cvref_t<decltype(pack)>;
        if constexpr (Pack::isSolid)
            for (int first = 0; first < static_cast<int>(pack.count); first += width)
                for (const Interval<Lanes>& span : pack.template spans<Lanes>(ray, first)) {
                    std::uint32_t ahead = core::bitsOf(span.exists & (span.leave > Lanes(0.f)));
                    // Behind the last object stand copies of it.
                    const int left = static_cast<int>(pack.count) - first;
                    if (left < width) ahead &= (1u << left) - 1;
                    if (ahead == 0) continue;
                    const core::LaneArray<Lanes> enter(span.enter), leave(span.leave);
                    core::forEachLane(
                        ahead, [&](int lane) { addSpan(enter[lane], leave[lane], pack.instance[first + lane]); });
                }
    }
    void add(const core::Ray<Lanes>&, const core::Rayf& ray, const MeshPack& pack) {
        const core::Rayf own = pack.place.toObject(core::Rayf{ray.origin, ray.direction, core::infinity});
        const TriangleRay<float> triangleRay(own);
        const TriangleRay<Lanes, UniformAxes> lanesRay(triangleRay);
        const BoxRay<Lanes> boxRay = boxRayFor<Lanes>(*pack.tree, ReadyRay(own));
        const float endless = core::infinity;
        // How many times more the whole way leaves than it enters: so often it starts inside. A mesh that holds the
        // start is never beyond the end.
        int inside = 0;
        walkTree(pack.tree->root(), boxRay, endless, [&](const void* at) {
            const auto& leaf = *static_cast<const TriangleLeaf*>(at);
            counts_.tests += treeWidth;
            for (int first = 0; first < treeWidth; first += width)
                leaf.triangles.intersect(lanesRay, first, [&](const TriangleHit<Lanes>& hits) {
                    const core::LaneArray<Lanes> t(hits.t), b1(hits.b1), b2(hits.b2);
                    core::forEachLane(core::bitsOf(hits.t < Lanes(core::infinity)), [&](int lane) {
                        const int side = sideOf(triangleRay, leaf, first + lane);
                        if (side == 0) return;
                        const bool enters = (side > 0) != (triangleRay.scale > 0);
                        inside += enters ? -1 : 1;
                        found_.push_back(
                            {{t[lane], pack.instance[0], leaf.triangle[first + lane], b1[lane], b2[lane]}, enters});
                    });
                });
            return false;
        });
        for (int i = 0; i < std::abs(inside); ++i) found_.push_back({{0, pack.instance[0]}, inside > 0});
    }
    // Nobody makes an operand of one.
    void add(const core::Ray<Lanes>&, const core::Rayf&, const CsgPack&) {}

    // On which side of all of a triangle's edges the ray passes, or 0.
    static int sideOf(const TriangleRay<float>& ray, const TriangleLeaf& leaf, int place) {
        core::Vec2f corner[3];
        for (int i = 0; i < 3; ++i) corner[i] = ray.sheared(ray.axes.permute(leaf.triangles.corner(place, i)));
        return sideOfTriangle(corner[0], corner[1], corner[2]);
    }

    void addEndless(const core::Rayf& ray, std::uint32_t i) {
        const core::Rayf own = scene_.instances[i].place.toObject(ray);
        ++counts_.tests;
        std::visit(
            [&]<class S>(const S& shape) {
                if constexpr (isSolidShape<S>)
                    for (const Interval<float>& span : shape.spans(own))
                        if (span.exists && span.leave > 0) addSpan(span.enter, span.leave, i);
            },
            scene_.instances[i].shape);
    }

    void addSpan(float enter, float leave, std::uint32_t instance) { gr::addSpan(enter, leave, instance, found_); }

    const Scene& scene_;
    const Csg& csg_;
    TraversalCounts& counts_;
    std::vector<CsgCrossing>& found_;
};

}  // namespace gr
