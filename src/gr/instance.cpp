#include "gr/scene.h"

namespace gr {

core::Bounds boundsOf(const Shape& shape) {
    return std::visit(
        []<class S>(const S& s) {
            if constexpr (std::is_pointer_v<S>)
                return s->bounds();
            else
                return s.bounds();
        },
        shape);
}

namespace {

// How far it reaches from the middle of its bounds along the world's axes.
core::Vec3f reachOf(const Shape& shape, const core::Transform& map) {
    const auto reach = [&]<class S>(const S& s) {
        if constexpr (std::is_pointer_v<S>)
            return reachOfBox(map, s->bounds().size() * 0.5f);
        else
            return s.reachUnder(map);
    };
    return std::visit(reach, shape);
}

}  // namespace

core::Bounds Instance::bounds() const {
    const core::Transform map = place.worldFromObject();
    const core::Bounds own = boundsOf(shape);
    const core::Vec3f middle = isEndless(shape) ? core::Vec3f(0) : (own.low + own.high) * 0.5f;
    const core::Vec3f centre = map.point(middle), reach = reachOf(shape, map);
    const core::Bounds exact{centre - reach, centre + reach};
    return isEndless(shape) ? exact.widened(2 * error) : exact.widened(2 * (error + errorPerUnit() * exact.reach()));
}

}  // namespace gr
