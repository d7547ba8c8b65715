#include "gr/scene.h"

namespace gr {
namespace {

// In the object's own space, and how far it reaches from the middle of that along the world's axes.
struct Reach {
    core::Bounds object;
    core::Vec3f inWorld;
};

Reach reachOf(const Shape& shape, const core::Transform& map) {
    const auto reach = [&]<class S>(const S& s) -> Reach {
        if constexpr (std::is_pointer_v<S>)
            return {s->bounds(), reachOfBox(map, s->bounds().size() * 0.5f)};
        else
            return {s.bounds(), s.reachUnder(map)};
    };
    return std::visit(reach, shape);
}

}  // namespace

core::Bounds Instance::bounds() const {
    const core::Transform map = place.worldFromObject();
    const Reach reach = reachOf(shape, map);
    const core::Vec3f middle = isEndless(shape) ? core::Vec3f(0) : (reach.object.low + reach.object.high) * 0.5f;
    const core::Vec3f centre = map.point(middle);
    const core::Bounds exact{centre - reach.inWorld, centre + reach.inWorld};
    return isEndless(shape) ? exact.widened(2 * error) : exact.widened(2 * (error + errorPerUnit() * exact.reach()));
}

}  // namespace gr
