#include "gr/shape.h"

namespace gr {

ShapePoint Box::surfaceAt(const core::Rayf& ray, const Hit& hit, const core::Vec3f& margin) const {
    bool outside = false;
    for (int i = 0; i < 3; ++i) outside |= ray.origin[i] < 0 || ray.origin[i] > 1;
    // The face is the nearest of those that a ray from there can meet: never one that looks the other way, however
    // near the edge to it.
    core::Vec3f p = ray.origin + ray.direction * hit.t;
    core::Vec3f plane;
    int axis = 0;
    for (int i = 0; i < 3; ++i) {
        plane[i] = (ray.direction[i] > 0) != outside ? 1.f : 0.f;
        if (std::abs(p[i] - plane[i]) < std::abs(p[axis] - plane[axis])) axis = i;
    }
    for (int i = 0; i < 3; ++i) {
        const float least = core::min(margin[i], 0.5f);
        p[i] = core::min(core::max(p[i], least), 1 - least);
    }
    p[axis] = plane[axis];
    core::Vec3f normal(0);
    normal[axis] = 2 * plane[axis] - 1;
    return {p, normal, outside};
}

}  // namespace gr
