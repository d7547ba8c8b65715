// What the rays of all lanes meet of a CSG object. To be compiled for each instruction set.
#pragma once

#include "gr/accelerators/lane_rays.h"
#include "gr/csg/csg_lanes.h"
#include "gr/csg/csg_tracer.h"

namespace gr {

template<class Real>
class CsgLaneTracer {
public:
    using Mask = core::Mask<Real>;

    CsgLaneTracer(const Scene& scene, const Csg& csg) : scene_(scene), csg_(csg) {}

    // For the lanes that are asked: the first hit that is not beyond `last`, nor where the ray ends.
    HitOf<Real> first(const core::Ray<Real>& ray, const Mask& asked, const Real& last) const {
        TraversalCounts counts;
        if (!CsgLanes<Real>::isFor(csg_)) {
            const Mask near = asked & LaneBoxRays<Real>(csg_.bounded().objects(), ray, last).mayMeet();
            return oneByOne({}, counts, core::bitsOf(near), ray, last,
                            [&](const CsgTracer<TreeLanes>& tracer, const core::Rayf& one, int, float end) {
                                return tracer.first(one, end);
                            });
        }
        // The lanes test a small one all at once, and one after the other where that does not tell what they meet.
        const CsgLanes<Real> lanes(scene_, csg_, ray, counts);
        std::uint32_t rest = core::bitsOf(asked) & lanes.lanes();
        HitOf<Real> hit;
        if (rest != 0 && lanes.haveTable()) {
            const auto found = lanes.first(ray, asked, last);
            hit = found.hit;
            rest = core::bitsOf(found.isUnclear);
        }
        return oneByOne(hit, counts, rest, ray, last,
                        [&](const CsgTracer<TreeLanes>& tracer, const core::Rayf& one, int lane, float end) {
                            return tracer.first(one, lanes, lane, end);
                        });
    }

private:
    // Replaces the hits of some lanes by f(tracer, ray, lane, last) of each.
    template<class F>
    HitOf<Real> oneByOne(const HitOf<Real>& hit, TraversalCounts& counts, std::uint32_t which,
                         const core::Ray<Real>& ray, const Real& last, F&& f) const {
        if (which == 0) return hit;
        const CsgTracer<TreeLanes> tracer(scene_, csg_, counts);
        HitLanes<Real> hits(hit);
        const LaneRays<Real> rays(ray);
        const core::LaneArray<Real> ends(last), tMax(ray.tMax);
        core::forEachLane(which,
                          [&](int lane) { hits.set(lane, f(tracer, rays.at(lane, tMax[lane]), lane, ends[lane])); });
        return hits.hit();
    }

    const Scene& scene_;
    const Csg& csg_;
};

}  // namespace gr
