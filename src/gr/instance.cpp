#include "gr/scene.h"

namespace gr {
namespace {

struct ObjectBounds {
    core::Bounds operator()(const Polyhedron* polyhedron) const { return polyhedron->bounds(); }
    core::Bounds operator()(const Sphere&) const { return {core::Vec3f(-1), core::Vec3f(1)}; }
    core::Bounds operator()(const Box&) const { return {core::Vec3f(0), core::Vec3f(1)}; }
    core::Bounds operator()(const Square&) const { return {{-0.5f, 0, -0.5f}, {0.5f, 0, 0.5f}}; }
};

}  // namespace

core::Bounds Instance::bounds() const {
    const core::Transform map = place.worldFromObject();
    const core::Bounds object = std::visit(ObjectBounds{}, shape);
    const core::Vec3f centre = map.point((object.low + object.high) * 0.5f), half = object.size() * 0.5f;
    // A sphere reaches as far along each world axis as the root of the sum of squares, a box's corners as far as the
    // sum.
    const core::Vec3f reach = std::holds_alternative<Sphere>(shape)
                                  ? glm::sqrt(map.x * map.x + map.y * map.y + map.z * map.z)
                                  : glm::abs(map.x) * half.x + glm::abs(map.y) * half.y + glm::abs(map.z) * half.z;
    const core::Bounds exact{centre - reach, centre + reach};
    return exact.widened(2 * (error + errorPerUnit() * exact.reach()));
}

}  // namespace gr
