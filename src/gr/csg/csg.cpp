#include "gr/csg/csg.h"

#include "gr/accelerators/object_tree.h"
#include "gr/scene.h"

#include <algorithm>

namespace gr {
namespace {

// What a half space holds, where it lies across an axis of the scene: half of it.
core::Bounds boundsOfHalfSpace(const Instance& instance) {
    core::Bounds bounds{core::Vec3f(-core::infinity), core::Vec3f(core::infinity)};
    const core::Transform map = instance.place.worldFromObject();
    const core::Vec3f normal = instance.place.objectFromWorld().transposed(core::Vec3f(0, 1, 0));
    for (int axis = 0; axis < 3; ++axis) {
        if (normal[(axis + 1) % 3] != 0 || normal[(axis + 2) % 3] != 0) continue;
        const float reach = std::abs(map.translation[axis]), place = map.translation[axis];
        const float beyond = 2 * (instance.error + instance.errorPerUnit() * reach);
        if (normal[axis] > 0)
            bounds.high[axis] = place + beyond;
        else
            bounds.low[axis] = place - beyond;
    }
    return bounds;
}

}  // namespace

Csg::Csg(CsgTree tree, std::uint32_t first) : tree_(std::move(tree)), first_(first) {}
Csg::~Csg() = default;

core::Bounds Csg::boundsIn(const Scene& scene) const {
    std::vector<core::Bounds> boxes;
    for (std::uint32_t i = first_; i < first_ + operandCount(); ++i) {
        const Instance& instance = scene.instances[i];
        boxes.push_back(gr::isEndless(instance.shape) ? boundsOfHalfSpace(instance) : instance.bounds());
    }
    return tree_.bounds(boxes);
}

void Csg::place(Scene& scene) {
    bounds_ = boundsIn(scene);
    // What lies beyond the whole does not matter.
    const float reach = bounds_.isEmpty() ? 0 : bounds_.reach();
    float error = 0;
    for (std::uint32_t i = first_; i < first_ + operandCount(); ++i) {
        const Instance& operand = scene.instances[i];
        error = std::max(error, operand.error + operand.errorPerUnit() * reach);
    }
    for (std::uint32_t i = first_; i < first_ + operandCount(); ++i) scene.instances[i].error = error;
    bounds_ = boundsIn(scene);
    tolerance_ = 2 * error;
}

void Csg::finish(const Scene& scene, MeshTrees& meshes) {
    std::vector<std::uint32_t> bounded;
    for (std::uint32_t i = first_; i < first_ + operandCount(); ++i) {
        const Shape& shape = scene.instances[i].shape;
        hasMeshes_ = hasMeshes_ || std::holds_alternative<const Polyhedron*>(shape);
        (gr::isEndless(shape) ? endless_ : bounded).push_back(i);
    }
    bounded_ = std::make_unique<ObjectTree>(scene, bounded, nullptr, meshes, 1);
}

std::size_t Csg::bytes() const {
    return sizeof(Csg) + tree_.bytes() + bounded_->objects().bytes() + endless_.capacity() * sizeof(endless_[0]);
}

}  // namespace gr
