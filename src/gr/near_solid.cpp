#include "gr/near_solid.h"

namespace gr {
namespace {

bool touch(const core::Bounds& a, const core::Bounds& b) {
    return !a.intersection(b).isEmpty();
}

// A box in the world, seen from the object's space.
core::Bounds inObjectSpace(const Instance& instance, const core::Bounds& box) {
    const core::Transform map = instance.place.objectFromWorld();
    const core::Vec3f centre = map.point((box.low + box.high) * 0.5f), half = box.size() * 0.5f;
    const core::Vec3f reach = glm::abs(map.x) * half.x + glm::abs(map.y) * half.y + glm::abs(map.z) * half.z;
    const core::Bounds bounds{centre - reach, centre + reach};
    return bounds.widened(1e-5f * bounds.reach());
}

}  // namespace

NearSolid::NearSolid(const Scene& scene, const Instance& instance, const core::Bounds& near)
    : scene_(&scene), instance_(&instance), isBeyond_(!touch(instance.bounds(), near)) {
    const auto* mesh = std::get_if<const Polyhedron*>(&instance.shape);
    if (isBeyond_ || mesh == nullptr) return;
    mesh_ = *mesh;
    const core::Bounds box = inObjectSpace(instance, near);
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < mesh_->triangleCount(); ++i) {
        Triangle triangle{{}, i};
        for (int corner = 0; corner < 3; ++corner) triangle.bounds.include(mesh_->vertex(i, corner));
        if (touch(triangle.bounds, box)) triangles.push_back(triangle);
    }
    isBeyond_ = triangles.empty();
    if (isBeyond_) return;
    addNodes(triangles, 0, triangles.size());
    for (const Triangle& triangle : triangles) triangles_.push_back(triangle.number);
}

// Halves, and halves of halves, cut across the longest side.
void NearSolid::addNodes(std::vector<Triangle>& triangles, std::size_t begin, std::size_t end) {
    constexpr std::size_t few = 8;
    const std::size_t place = nodes_.size();
    Node node{{}, 0, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin)};
    for (std::size_t i = begin; i < end; ++i) node.bounds.include(triangles[i].bounds);
    if (end - begin <= few) node.end = static_cast<std::uint32_t>(end);
    nodes_.push_back(node);
    if (end - begin > few) {
        const core::Vec3f size = node.bounds.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto centre = [axis](const Triangle& t) {
            return t.bounds.low[axis] * 0.5f + t.bounds.high[axis] * 0.5f;
        };
        const auto at = [&](std::size_t i) { return triangles.begin() + static_cast<std::ptrdiff_t>(i); };
        const std::size_t middle = (begin + end) / 2;
        std::nth_element(at(begin), at(middle), at(end),
                         [&](const Triangle& a, const Triangle& b) { return centre(a) < centre(b); });
        addNodes(triangles, begin, middle);
        addNodes(triangles, middle, end);
    }
    nodes_[place].next = static_cast<std::uint32_t>(nodes_.size());
}

void NearSolid::addCrossings(const core::Rayf& ray, std::vector<SolidCrossing>& crossings) const {
    if (mesh_ == nullptr) return gr::addCrossings(*scene_, *instance_, ray, crossings);
    const Line line(instance_->place.toObject(ray));
    if (!line.goesAnywhere()) return;
    const MeshLine meshLine(line);
    for (std::size_t i = 0; i < nodes_.size();) {
        const Node& node = nodes_[i];
        const bool mayMeet = line.mayMeet(node.bounds);
        i = mayMeet ? i + 1 : node.next;
        if (!mayMeet) continue;
        for (std::uint32_t k = node.begin; k < node.end; ++k) meshLine.addCrossing(*mesh_, triangles_[k], crossings);
    }
}

}  // namespace gr
