// What the rays of many paths meet, for all lanes at once.
#pragma once

#include "gr/accelerators/all_tracer.h"
#include "gr/accelerators/face_tracer.h"
#include "gr/accelerators/lane_rays.h"
#include "gr/body_surface.h"

namespace gr {

// The flat faces of a scene that has few are tested by the lanes, one after the other; all other objects are looked for
// as the accelerator says. A hit is the nearest by the same tests whichever finds it.
template<class Real>
class Tracer {
public:
    using Mask = core::Mask<Real>;
    using Vec3 = core::Vec3<Real>;

    // Both must outlive it. wantsCoordinates: whether surfaces tell u, v, a tangent and inNode.
    Tracer(const Scene& scene, const Accelerator& accelerator, bool wantsCoordinates)
        : scene_(scene),
          accelerator_(accelerator),
          tree_(accelerator.tree()),
          onlyMesh_(tree_ != nullptr ? tree_->onlyMesh() : nullptr),
          wantsCoordinates_(wantsCoordinates),
          faces_(scene.faces),
          bodies_(scene, scene.large) {
        if (accelerator.testsAll()) bodies_.add(scene, scene.bodies);
    }

    // The nearest hit of each lane that is alive.
    HitOf<Real> nearest(const core::Ray<Real>& ray, const Mask& alive, TraversalCounts& counts) const {
        counts.tests += testsEach() * static_cast<std::uint64_t>(core::countOf(alive));
        HitOf<Real> hit = faces_.nearest(ray);
        if (bodies_.count > 0) AllTracer<Real>(scene_, bodies_).nearest(ray, alive, hit);
        hit.t = core::select(alive, hit.t, Real(core::infinity));
        if (asksAccelerator()) nearestOneByOne(ray, alive, hit, counts);
        return hit;
    }

    // Whether anything stands between two points of the scene; for the lanes where that is asked.
    Mask occluded(const core::Ray<Real>& ray, const Mask& asked, TraversalCounts& counts) const {
        counts.tests += testsEach() * static_cast<std::uint64_t>(core::countOf(asked));
        Mask isMet = faces_.occluded(ray);
        if (bodies_.count > 0) isMet = isMet | AllTracer<Real>(scene_, bodies_).occluded(ray, asked & !isMet);
        const Mask rest = asked & !isMet;
        if (asksAccelerator() && core::any(rest)) isMet = isMet | occludedOneByOne(ray, rest, counts);
        return asked & isMet;
    }

    SurfacePoint<Real> surfaceAt(const core::Ray<Real>& ray, const HitOf<Real>& hit) const {
        SurfacePoint<Real> surface;
        surface.t = hit.t;
        surface.light = Real(-1);
        surface.isSmooth = Real(0) > Real(0);
        const Mask isMet = surface.isMet();
        if (bodies_.count == 0 && scene_.bodies.empty()) {
            faces_.setSurface(surface, ray, hit, isMet, wantsCoordinates_);
            return surface;
        }
        const Mask isFace = isMet & !core::isLess(hit.instance, core::UInt<Real>(FaceTracer<Real>::firstFace));
        faces_.setSurface(surface, ray, hit, isFace, wantsCoordinates_);
        std::uint32_t ids[core::laneCount<Real>];
        core::storeUInt<Real>(hit.instance, ids);
        for (std::uint32_t rest = core::bitsOf(isMet & !isFace); rest != 0;) {
            const std::uint32_t instance = ids[std::countr_zero(rest)];
            std::uint32_t here = 0;
            core::forEachLane(rest, [&](int lane) { here |= std::uint32_t{ids[lane] == instance} << lane; });
            rest &= ~here;
            const Mask onInstance = core::maskOf<Real>(here);
            BodySurface<Real>(scene_, instance, ray, hit, onInstance).set(surface, wantsCoordinates_);
        }
        return surface;
    }

private:
    bool asksAccelerator() const { return !accelerator_.testsAll() && !scene_.bodies.empty(); }
    std::uint64_t testsEach() const { return scene_.faces.size() + bodies_.count; }

    // For what is no tree.
    struct OtherRays {
        const Accelerator& accelerator;
        LaneRays<Real> rays;
        std::uint32_t asked;

        std::uint32_t lanes() const { return asked; }
        void nearest(int lane, Hit& found, TraversalCounts& counts) const {
            // What is just as near as what the lanes have found must be found, too: it may have been made first.
            const float end = std::nextafter(found.t, core::infinity);
            const std::optional<Hit> body = accelerator.intersect(rays.at(lane, end), counts);
            if (body && body->isBefore(found)) found = *body;
        }
        bool occluded(int lane, float end, TraversalCounts& counts) const {
            return accelerator.occluded(rays.at(lane, end), counts);
        }
    };

    // Calls f(rays) with the rays made ready for what the accelerator is. end: how far each goes.
    template<class F>
    auto withRays(const core::Ray<Real>& ray, const Mask& asked, const Real& end, F&& f) const {
        if (onlyMesh_ != nullptr) return f(LaneMeshRays<Real>(*onlyMesh_, ray, asked, end));
        if (tree_ != nullptr) return f(LaneTreeRays<Real>(scene_, *tree_, ray, asked, end));
        return f(OtherRays{accelerator_, LaneRays<Real>(ray), core::bitsOf(asked & (end > Real(0)))});
    }

    void nearestOneByOne(const core::Ray<Real>& ray, const Mask& alive, HitOf<Real>& hit,
                         TraversalCounts& counts) const {
        withRays(ray, alive, hit.t, [&](const auto& rays) {
            if (rays.lanes() == 0) return;
            HitLanes<Real> hits(hit);
            core::forEachLane(rays.lanes(), [&](int lane) {
                Hit found = hits.at(lane);
                rays.nearest(lane, found, counts);
                hits.set(lane, found);
            });
            hit = hits.hit();
        });
    }

    Mask occludedOneByOne(const core::Ray<Real>& ray, const Mask& asked, TraversalCounts& counts) const {
        return withRays(ray, asked, ray.tMax, [&](const auto& rays) -> Mask {
            if (rays.lanes() == 0) return Real(0) > Real(0);
            const core::LaneArray<Real> end(ray.tMax);
            std::uint32_t met = 0;
            core::forEachLane(rays.lanes(),
                              [&](int lane) { met |= std::uint32_t{rays.occluded(lane, end[lane], counts)} << lane; });
            return core::maskOf<Real>(met);
        });
    }

    const Scene& scene_;
    const Accelerator& accelerator_;
    const ObjectTree* tree_;
    const MeshPack* onlyMesh_;  // of the tree, or null
    bool wantsCoordinates_;
    FaceTracer<Real> faces_;
    InstancesByShape bodies_;  // that lanes test by themselves
};

}  // namespace gr
