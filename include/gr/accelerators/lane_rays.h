// The rays of all lanes made ready at once for what they then are asked one by one, which takes far less time than one
// after the other. All these classes tell which lanes come near it, and what those meet.
#pragma once

#include "gr/accelerators/tree_tracer.h"

namespace gr {

// For the boxes of a tree.
template<class Real>
class LaneBoxRays {
public:
    // end: how far each goes.
    LaneBoxRays(const WideTree& tree, const core::Ray<Real>& ray, const Real& end) {
        const Real slack = tree.slack(core::largestComponent(ray.origin));
        constexpr float most = ReadyRay::most;
        Real enter(0), leave = end;
        for (int axis = 0; axis < 3; ++axis) {
            const Real inverse = core::min(core::max(Real(1) / ray.direction[axis], Real(-most)), Real(most));
            const core::Mask<Real> isBackwards = inverse < Real(0);
            const Real outwards = core::select(isBackwards, -slack, slack);
            const Real near = (ray.origin[axis] + outwards) * inverse, far = (ray.origin[axis] - outwards) * inverse;
            const Real low(tree.bounds().low[axis]), high(tree.bounds().high[axis]);
            enter = core::max(Real(core::select(isBackwards, high, low) * inverse - near), enter);
            leave = core::min(Real(core::select(isBackwards, low, high) * inverse - far), leave);
            inverse_[axis] = Array(inverse);
            near_[axis] = Array(near);
            far_[axis] = Array(far);
        }
        mayMeet_ = enter <= leave;
    }

    // Which come near the box round all that is in the tree.
    const core::Mask<Real>& mayMeet() const { return mayMeet_; }

    BoxRay<TreeLanes> at(int lane) const {
        BoxRay<TreeLanes> ray;
        for (int axis = 0; axis < 3; ++axis) ray.set(axis, inverse_[axis][lane], near_[axis][lane], far_[axis][lane]);
        return ray;
    }

private:
    using Array = core::LaneArray<Real>;

    Array inverse_[3], near_[3], far_[3];
    core::Mask<Real> mayMeet_;
};

// As they are.
template<class Real>
class LaneRays {
public:
    explicit LaneRays(const core::Ray<Real>& ray)
        : origin_{Array(ray.origin.x), Array(ray.origin.y), Array(ray.origin.z)},
          direction_{Array(ray.direction.x), Array(ray.direction.y), Array(ray.direction.z)} {}

    core::Rayf at(int lane, float end) const {
        return {{origin_[0][lane], origin_[1][lane], origin_[2][lane]},
                {direction_[0][lane], direction_[1][lane], direction_[2][lane]},
                end};
    }

private:
    using Array = core::LaneArray<Real>;

    Array origin_[3], direction_[3];
};

// For any tree.
template<class Real>
class LaneTreeRays {
public:
    LaneTreeRays(const Scene& scene, const ObjectTree& tree, const core::Ray<Real>& ray, const core::Mask<Real>& asked,
                 const Real& end)
        : scene_(scene),
          tree_(tree),
          rays_(ray),
          boxRays_(tree.objects(), ray, end),
          lanes_(core::bitsOf(asked & boxRays_.mayMeet())) {}

    std::uint32_t lanes() const { return lanes_; }
    // Replaces `found` by what comes before it.
    void nearest(int lane, Hit& found, TraversalCounts& counts) const {
        TreeTracer<TreeLanes>(scene_, tree_, counts).nearest(rays_.at(lane, core::infinity), boxRays_.at(lane), found);
    }
    bool occluded(int lane, float end, TraversalCounts& counts) const {
        return TreeTracer<TreeLanes>(scene_, tree_, counts).occluded(rays_.at(lane, end), boxRays_.at(lane));
    }

private:
    const Scene& scene_;
    const ObjectTree& tree_;
    LaneRays<Real> rays_;
    LaneBoxRays<Real> boxRays_;
    std::uint32_t lanes_;
};

// For a tree with one mesh in it and nothing else: they are all taken to its own space.
template<class Real>
class LaneMeshRays {
public:
    LaneMeshRays(const MeshPack& mesh, const core::Ray<Real>& ray, const core::Mask<Real>& asked, const Real& end)
        : mesh_(mesh), ray_(mesh.place.toObject(ray)), boxRays_(*mesh.tree, ray_, end) {
        lanes_ = core::bitsOf(asked & boxRays_.mayMeet());
        if (lanes_ != 0) readyForTriangles();
    }

    std::uint32_t lanes() const { return lanes_; }
    void nearest(int lane, Hit& found, TraversalCounts& counts) const {
        MeshTracer<TreeLanes>(mesh_, counts).nearest({boxRays_.at(lane), triangleRay(lane, core::infinity)}, found);
    }
    bool occluded(int lane, float end, TraversalCounts& counts) const {
        return MeshTracer<TreeLanes>(mesh_, counts).occluded({boxRays_.at(lane), triangleRay(lane, end)}, end);
    }

private:
    using Array = core::LaneArray<Real>;

    void readyForTriangles() {
        const TriangleRay<Real, LaneAxes<Real>> ready(ray_);
        xLast_ = core::bitsOf(ready.axes.xLast);
        yLast_ = core::bitsOf(ready.axes.yLast);
        for (int axis = 0; axis < 3; ++axis) origin_[axis] = Array(ready.origin[axis]);
        slopeX_ = Array(ready.slopeX);
        slopeY_ = Array(ready.slopeY);
        scale_ = Array(ready.scale);
    }
    TriangleRay<TreeLanes, UniformAxes> triangleRay(int lane, float end) const {
        const auto all = [&](const Array& numbers) { return TreeLanes(numbers[lane]); };
        const int last = xLast_ >> lane & 1 ? 0 : yLast_ >> lane & 1 ? 1 : 2;
        return {UniformAxes(last), {all(origin_[0]), all(origin_[1]), all(origin_[2])},
                all(slopeX_),      all(slopeY_),
                all(scale_),       TreeLanes(end)};
    }

    const MeshPack& mesh_;
    core::Ray<Real> ray_;  // in the mesh's own space
    LaneBoxRays<Real> boxRays_;
    std::uint32_t lanes_;
    std::uint32_t xLast_, yLast_;  // a bit for each lane; this and what follows only where there are lanes
    Array origin_[3], slopeX_, slopeY_, scale_;
};

}  // namespace gr
