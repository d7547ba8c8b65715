// What the rays of many paths meet, for all lanes at once.
#pragma once

#include "gr/accelerators/tree_tracer.h"
#include "gr/all_tracer.h"
#include "gr/face_tracer.h"

namespace gr {

// The flat faces of a scene that has few are tested by the lanes, one after the other; all other objects are looked for
// as the accelerator says. A hit is the nearest by the same tests whichever finds it.
template<class Real>
class Tracer {
public:
    using Mask = core::Mask<Real>;
    using Vec3 = core::Vec3<Real>;

    // Both must outlive it. wantsTangents: whether surfaces tell them.
    Tracer(const Scene& scene, const Accelerator& accelerator, bool wantsTangents)
        : scene_(scene),
          accelerator_(accelerator),
          tree_(accelerator.tree()),
          wantsTangents_(wantsTangents),
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

    SurfacePointOf<Real> surfaceAt(const core::Ray<Real>& ray, const HitOf<Real>& hit) const {
        SurfacePointOf<Real> surface;
        surface.t = hit.t;
        surface.light = Real(-1);
        surface.isSmooth = Real(0) > Real(0);
        const Mask isMet = surface.isMet();
        if (bodies_.count == 0 && scene_.bodies.empty()) {
            faces_.setSurface(surface, ray, hit, isMet, wantsTangents_);
            return surface;
        }
        const Mask isFace = isMet & !core::isLess(hit.instance, core::UInt<Real>(FaceTracer<Real>::firstFace));
        faces_.setSurface(surface, ray, hit, isFace, wantsTangents_);
        std::uint32_t ids[core::laneCount<Real>];
        core::storeUInt<Real>(hit.instance, ids);
        for (std::uint32_t rest = core::bitsOf(isMet & !isFace); rest != 0;) {
            const std::uint32_t instance = ids[std::countr_zero(rest)];
            std::uint32_t here = 0;
            core::forEachLane(rest, [&](int lane) { here |= std::uint32_t{ids[lane] == instance} << lane; });
            rest &= ~here;
            setBody(surface, ray, hit, scene_.instances[instance], core::maskOf<Real>(here));
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

    void setBody(SurfacePointOf<Real>& surface, const core::Ray<Real>& ray, const HitOf<Real>& hit,
                 const Instance& instance, const Mask& here) const {
        const auto inObjectSpace = [&](const core::Ray<Real>& objectRay, const Vec3& margin) {
            return std::visit([&](const auto& shape) { return shapePoint(shape, objectRay, hit, here, margin); },
                              instance.shape);
        };
        const PlacedPoint<Real> point = placed(instance, ray, surface.t, inObjectSpace);
        surface.position = core::select(here, point.position, surface.position);
        surface.normal = core::select(here, point.normal, surface.normal);
        surface.error = core::select(here, point.error, surface.error);
        surface.material = core::select(here, Real(static_cast<float>(instance.material)), surface.material);
        if (const auto* square = std::get_if<Square>(&instance.shape))
            surface.light = core::select(here, Real(static_cast<float>(square->light)), surface.light);
        Vec3 shadingNormal = point.normal, objectNormal = point.objectNormal;
        if (const auto* mesh = std::get_if<const Polyhedron*>(&instance.shape); mesh && (*mesh)->hasNormals())
            smooth(**mesh, instance, ray, hit, here, point, shadingNormal, objectNormal, surface.isSmooth);
        surface.shadingNormal = core::select(here, shadingNormal, surface.shadingNormal);
        if (wantsTangents_)
            surface.tangent = core::select(here, tangentAt<Real>(instance, objectNormal), surface.tangent);
    }

    template<class S>
    static ShapePoint<Real> shapePoint(const S& shape, const core::Ray<Real>& ray, const HitOf<Real>& hit, const Mask&,
                                       const Vec3& margin) {
        return shape.surfaceAt(ray, hit.t, margin);
    }
    static ShapePoint<Real> shapePoint(const Polyhedron* mesh, const core::Ray<Real>& ray, const HitOf<Real>& hit,
                                       const Mask& here, const Vec3& margin) {
        return mesh->surfaceAt<Real>(ray, ofMesh(hit, here), margin);
    }
    // Lanes that hit something else may have the number of a triangle that this mesh has not.
    static HitOf<Real> ofMesh(const HitOf<Real>& hit, const Mask& here) {
        HitOf<Real> own = hit;
        own.triangle = core::selectUInt<Real>(here, hit.triangle, core::UInt<Real>(0));
        return own;
    }

    // A mesh's own normals stand for a shape that is rounder than its faces. They change how light is reflected, never
    // which side of a face something is on.
    static void smooth(const Polyhedron& mesh, const Instance& instance, const core::Ray<Real>& ray,
                       const HitOf<Real>& hit, const Mask& here, const PlacedPoint<Real>& point, Vec3& shadingNormal,
                       Vec3& objectNormal, Mask& isSmooth) {
        const Vec3 given = mesh.shadingNormal<Real>(ofMesh(hit, here));
        const Vec3 normal = glm::normalize(instance.place.objectFromWorld().transposed(given));
        const Mask isGiven = here & (glm::dot(normal, point.normal) > Real(0));
        if (!core::any(isGiven)) return;
        shadingNormal = core::select(isGiven, facing<Real>(normal, ray.direction, point.front), shadingNormal);
        objectNormal = core::select(isGiven, given, objectNormal);
        isSmooth = isSmooth | isGiven;
    }

    const Scene& scene_;
    const Accelerator& accelerator_;
    const TreeAccelerator* tree_;
    bool wantsTangents_;
    FaceTracer<Real> faces_;
    InstancesByShape bodies_;  // that lanes test by themselves
};

}  // namespace gr
