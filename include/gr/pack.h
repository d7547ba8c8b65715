// Things of one kind side by side, a lane each, so that one ray is tested against a whole pack in one go.
// For baseline code only: in a file compiled for a wider instruction set the types would be others.
#pragma once

#include "core/transform.h"
#include "gr/shape.h"
#include "gr/triangle.h"

#include <array>

namespace gr {

// As many lanes as the least processor has.
using PackLanes = xsimd::batch<float>;
inline constexpr int packWidth = 4;
static_assert(PackLanes::size == packWidth);

// The lanes, to be looked at one by one.
struct LaneValues {
    alignas(16) float lane[packWidth];

    explicit LaneValues(const PackLanes& lanes) { lanes.store_aligned(lane); }
    float operator[](int i) const { return lane[i]; }
};

inline core::Ray<PackLanes> broadcast(const core::Rayf& ray) {
    return {core::broadcast<PackLanes>(ray.origin), core::broadcast<PackLanes>(ray.direction), PackLanes(ray.tMax)};
}

// A ray made ready to be tested against packs of triangles.
struct PackRay : TriangleRay<PackLanes, UniformAxes> {
    explicit PackRay(const core::Rayf& ray) : TriangleRay(TriangleRay<float>(ray)) {}
};

// Triangles. A lane of zeros holds an empty triangle, which no ray meets.
struct alignas(16) TrianglePack {
    float vertex[3][3][packWidth];  // [vertex][axis][lane]

    void set(int lane, const std::array<core::Vec3f, 3>& v) {
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis) vertex[corner][axis][lane] = v[corner][axis];
    }
    core::Vec3f corner(int lane, int i) const { return {vertex[i][0][lane], vertex[i][1][lane], vertex[i][2][lane]}; }

    // Calls found(hit) where the ray meets any. Most packs are missed by most rays: the exact areas, and how far along
    // the ray, are asked only where one is not.
    template<class Found>
    void intersect(const PackRay& ray, Found&& found) const {
        const core::Vec3<PackLanes> a = load(ray, 0), b = load(ray, 1), c = load(ray, 2);
        if (!xsimd::any(ray.cross(a, b, c).inside)) return;
        found(ray.hit(ray.exactCross(a, b, c), a, b, c));
    }

private:
    core::Vec3<PackLanes> load(const PackRay& ray, int corner) const {
        const auto axis = [&](int k) { return PackLanes::load_aligned(vertex[corner][k]); };
        return {axis(ray.axes.x), axis(ray.axes.y), axis(ray.axes.z)};
    }
};

// Instances of a shape without parameters of its own. A lane that is not used repeats another one.
template<class Shape>
struct InstancePack {
    core::AffineMap<PackLanes> objectFromWorld;
    std::uint32_t instance[packWidth];

    // The t of each, or infinity.
    PackLanes intersect(const core::Ray<PackLanes>& ray) const {
        return Shape{}.intersect(
            core::Ray<PackLanes>{objectFromWorld.point(ray.origin), objectFromWorld.vector(ray.direction), ray.tMax});
    }
};

}  // namespace gr
