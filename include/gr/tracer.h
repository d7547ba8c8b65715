// What the rays of many paths meet, for all lanes at once.
#pragma once

#include "gr/accelerators/tree_tracer.h"
#include "gr/all_tracer.h"
#include "gr/body_surface.h"
#include "gr/face_tracer.h"

namespace gr {

// The flat faces of a scene that has few are tested by the lanes, one after the other; all other objects are looked for
// as the accelerator says. A hit is the nearest by the same tests whichever finds it.
template<class Real>
class Tracer {
public:
    using Mask = core::Mask<Real>;
    using Vec3 = core::Vec3<Real>;

    // Both must outlive it. wantsCoordinates: whether surfaces tell u, v and a tangent.
    Tracer(const Scene& scene, const Accelerator& accelerator, bool wantsCoordinates)
        : scene_(scene),
          accelerator_(accelerator),
          tree_(accelerator.tree()),
          wantsCoordinates_(wantsCoordinates),
          faces_(scene.faces),
          bodies_(scene, scene.large) {
        if (accelerator.testsAll()) bodies_.add(scene, scene.bodies);
    }

    // The nearest hit of each lane that is alive.
    HitOf<Real> nearest(const core::Ray<Real>& ray, const Mask& alive, TraversalCounts& counts) const {
        counts.tests += testsEach() * static_cast<std::uint64_t>(core::countOf(alive));
        HitOf<Real> hit = faces_.nearest(ray);
        if (bodies_.count > 0) AllTracer<Real>(scene_, bodies_).nearest(ray, hit);
        hit.t = core::select(alive, hit.t, Real(core::infinity));
        if (asksAccelerator()) nearestOneByOne(ray, alive, hit, counts);
        return hit;
    }

    // Whether anything stands between two points of the scene; for the lanes where that is asked.
    Mask occluded(const core::Ray<Real>& ray, const Mask& asked, TraversalCounts& counts) const {
        counts.tests += testsEach() * static_cast<std::uint64_t>(core::countOf(asked));
        Mask isMet = faces_.occluded(ray);
        if (bodies_.count > 0) isMet = isMet | AllTracer<Real>(scene_, bodies_).occluded(ray);
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
            BodySurface<Real>(scene_.instances[instance], ray, hit, onInstance).set(surface, wantsCoordinates_);
        }
        return surface;
    }

private:
    bool asksAccelerator() const { return !accelerator_.testsAll() && !scene_.bodies.empty(); }
    std::uint64_t testsEach() const { return scene_.faces.size() + bodies_.count; }

    // The lanes of a ray, to be asked one by one, made ready for the tree.
    struct RayArray {
        using Array = core::LaneArray<Real>;
        Array origin[3], direction[3], inverse[3], near[3], far[3];

        explicit RayArray(const core::Ray<Real>& ray)
            : origin{Array(ray.origin.x), Array(ray.origin.y), Array(ray.origin.z)},
              direction{Array(ray.direction.x), Array(ray.direction.y), Array(ray.direction.z)} {}
        core::Rayf at(int lane, float tMax) const {
            return {{origin[0][lane], origin[1][lane], origin[2][lane]},
                    {direction[0][lane], direction[1][lane], direction[2][lane]},
                    tMax};
        }
        BoxRay<TreeLanes> boxRay(int lane) const {
            BoxRay<TreeLanes> ray;
            for (int axis = 0; axis < 3; ++axis) ray.set(axis, inverse[axis][lane], near[axis][lane], far[axis][lane]);
            return ray;
        }
    };

    void nearestOneByOne(const core::Ray<Real>& ray, const Mask& alive, HitOf<Real>& hit,
                         TraversalCounts& counts) const {
        RayArray rays(ray);
        const std::uint32_t asked = core::bitsOf(alive & mayMeet(ray, hit.t, rays));
        if (asked == 0) return;
        core::LaneArray<Real> t(hit.t), b1(hit.b1), b2(hit.b2);
        std::uint32_t instance[core::laneCount<Real>], triangle[core::laneCount<Real>];
        core::storeUInt<Real>(hit.instance, instance);
        core::storeUInt<Real>(hit.triangle, triangle);
        core::forEachLane(asked, [&](int lane) {
            Hit found{t[lane], instance[lane], triangle[lane], b1[lane], b2[lane]};
            if (tree_ != nullptr) {
                TreeTracer<TreeLanes>(*tree_, counts).nearest(rays.at(lane, core::infinity), rays.boxRay(lane), found);
            } else {
                // What is just as near as what the lanes have found must be found, too: it may have been made first.
                const float end = std::nextafter(found.t, core::infinity);
                const std::optional<Hit> body = accelerator_.intersect(rays.at(lane, end), counts);
                if (body && body->isBefore(found)) found = *body;
            }
            t[lane] = found.t;
            b1[lane] = found.b1;
            b2[lane] = found.b2;
            instance[lane] = found.instance;
            triangle[lane] = found.triangle;
        });
        hit = {t.real(), core::loadUInt<Real>(instance), core::loadUInt<Real>(triangle), b1.real(), b2.real()};
    }

    Mask occludedOneByOne(const core::Ray<Real>& ray, const Mask& asked, TraversalCounts& counts) const {
        RayArray rays(ray);
        const std::uint32_t rest = core::bitsOf(asked & mayMeet(ray, ray.tMax, rays));
        if (rest == 0) return Real(0) > Real(0);
        const core::LaneArray<Real> tMax(ray.tMax);
        std::uint32_t met = 0;
        core::forEachLane(rest, [&](int lane) {
            const core::Rayf one = rays.at(lane, tMax[lane]);
            const bool isMet = tree_ != nullptr ? TreeTracer<TreeLanes>(*tree_, counts).occluded(one, rays.boxRay(lane))
                                                : accelerator_.occluded(one, counts);
            met |= std::uint32_t{isMet} << lane;
        });
        return core::maskOf<Real>(met);
    }

    // Whether rays come near the box round all of the tree's objects before `end`; they are made ready for its boxes.
    Mask mayMeet(const core::Ray<Real>& ray, const Real& end, RayArray& rays) const {
        if (tree_ == nullptr) return end > Real(0);
        const WideTree& tree = tree_->objects();
        const Real slack = tree.slack(core::largestComponent(ray.origin));
        constexpr float most = std::numeric_limits<float>::max();
        Real enter(0), leave = end;
        for (int axis = 0; axis < 3; ++axis) {
            const Real inverse = core::min(core::max(Real(1) / ray.direction[axis], Real(-most)), Real(most));
            const Mask isBackwards = inverse < Real(0);
            const Real outwards = core::select(isBackwards, -slack, slack);
            const Real near = (ray.origin[axis] + outwards) * inverse, far = (ray.origin[axis] - outwards) * inverse;
            const Real low(tree.bounds().low[axis]), high(tree.bounds().high[axis]);
            enter = core::max(Real(core::select(isBackwards, high, low) * inverse - near), enter);
            leave = core::min(Real(core::select(isBackwards, low, high) * inverse - far), leave);
            rays.inverse[axis] = core::LaneArray<Real>(inverse);
            rays.near[axis] = core::LaneArray<Real>(near);
            rays.far[axis] = core::LaneArray<Real>(far);
        }
        return enter <= leave;
    }

    const Scene& scene_;
    const Accelerator& accelerator_;
    const TreeAccelerator* tree_;
    bool wantsCoordinates_;
    FaceTracer<Real> faces_;
    InstancesByShape bodies_;  // that lanes test by themselves
};

}  // namespace gr
