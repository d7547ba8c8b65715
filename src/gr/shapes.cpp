#include "gr/shape.h"

namespace gr {

ShapePoint Box::surfaceAt(const core::Rayf& ray, const Hit& hit) const {
    core::Vec3f p = ray.origin + ray.direction * hit.t;

    // The face is the one whose plane is nearest; the hit lies in it exactly.
    int axis = 0;
    float nearest = core::infinity;
    for (int i = 0; i < 3; ++i) {
        const float distance = std::min(std::abs(p[i]), std::abs(1 - p[i]));
        if (distance < nearest) {
            nearest = distance;
            axis = i;
        }
    }
    // Rounding may put a hit beyond an edge. It is put back inside by what the way to the world and back can move it,
    // so that a ray that goes on from inside the box does not start outside.
    constexpr float margin = 16 * 0x1p-23f;
    for (int i = 0; i < 3; ++i) p[i] = std::min(std::max(p[i], margin), 1 - margin);
    const bool upper = (ray.origin + ray.direction * hit.t)[axis] > 0.5f;
    p[axis] = upper ? 1.f : 0.f;
    core::Vec3f normal(0);
    normal[axis] = upper ? 1.f : -1.f;
    return {p, normal};
}

}  // namespace gr
