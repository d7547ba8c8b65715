// Those who trace the same rays, on one thread: our tracer, with the widest lanes that this file is compiled for, and
// Embree with its own triangles, asked for one ray at a time and for sixteen.
#pragma once

#include "gr/tracer.h"
#include "native_embree.h"
#include "trace_rays.h"

#include <algorithm>
#include <iterator>

namespace bench {

// What is asked: the t of the nearest hit, or infinity; or whether there is any, 1 or 0.
enum class Question { nearest, occluded };

// Each writes an answer for each ray.
class OurTracer {
public:
    using Lanes = core::Lanes;

    OurTracer(const gr::Scene& scene, const gr::Accelerator& accelerator) : tracer_(scene, accelerator, false) {}

    void answer(const RayPacks& rays, Question question, float* answers) const {
        const core::Mask<Lanes> all = Lanes(0) < Lanes(1);
        gr::TraversalCounts counts;
        for (const RayPack& pack : rays.packs())
            for (int first = 0; first < RayPack::width; first += core::laneCount<Lanes>) {
                const core::Ray<Lanes> ray = pack.lanes<Lanes>(first);
                Lanes result = question == Question::nearest
                                   ? tracer_.nearest(ray, all, counts).t
                                   : core::select(tracer_.occluded(ray, all, counts), Lanes(1), Lanes(0));
                result.store_unaligned(answers);
                answers += core::laneCount<Lanes>;
            }
    }

private:
    gr::Tracer<Lanes> tracer_;
};

inline void answerOneByOne(const NativeTriangles& triangles, const RayPacks& rays, Question question, float* answers) {
    NativeQuery query(false);
    for (const RayPack& pack : rays.packs())
        for (int place = 0; place < RayPack::width; ++place) {
            const core::Rayf ray = pack.at(place);
            *answers++ = question == Question::nearest ? triangles.intersect(ray, query)
                                                       : static_cast<float>(triangles.occluded(ray, query));
        }
}

// areCoherent: see NativeQuery.
inline void answerSixteen(const NativeTriangles& triangles, const RayPacks& rays, Question question, bool areCoherent,
                          float* answers) {
    alignas(64) int all[16];
    std::fill(std::begin(all), std::end(all), -1);
    NativeQuery query(areCoherent);
    for (const RayPack& pack : rays.packs()) {
        RTCRayHit16 hit;
        pack.copyTo(hit.ray);
        if (question == Question::nearest) {
            std::fill(std::begin(hit.hit.geomID), std::end(hit.hit.geomID), RTC_INVALID_GEOMETRY_ID);
            query.ask(triangles.scene(), all, hit);
        } else {
            query.ask(triangles.scene(), all, hit.ray);
        }
        // A ray that is occluded ends before it begins.
        for (int i = 0; i < 16; ++i)
            *answers++ = question == Question::nearest ? hit.ray.tfar[i] : static_cast<float>(hit.ray.tfar[i] < 0);
    }
}

}  // namespace bench
