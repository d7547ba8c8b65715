#include "gr/scene.h"

namespace gr {

core::Bounds Instance::bounds() const {
    const core::Transform map = place.worldFromObject();
    const core::Bounds own = boundsOf(shape);
    const core::Vec3f middle = isEndless(shape) ? core::Vec3f(0) : (own.low + own.high) * 0.5f;
    const core::Vec3f reach = visitShape(shape, [&](const auto& s) { return s.reachUnder(map); });
    const core::Vec3f centre = map.point(middle);
    const core::Bounds exact{centre - reach, centre + reach};
    return isEndless(shape) ? exact.widened(2 * error) : exact.widened(2 * (error + errorPerUnit() * exact.reach()));
}

}  // namespace gr
