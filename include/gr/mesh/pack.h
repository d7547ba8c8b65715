// Things of one kind side by side, a lane each, so that one ray is tested against a whole pack in one go.
#pragma once

#include "gr/mesh/triangle.h"
#include "gr/shape.h"

#include <array>

namespace gr {

// As many lanes as the least processor has.
inline constexpr int packWidth = 4;
using PackLanes = xsimd::make_sized_batch_t<float, packWidth>;

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

// Triangles. A place of zeros holds an empty triangle, which no ray meets.
template<int width>
struct alignas(4 * width) TrianglePackOf {
    float vertex[3][3][width];  // [vertex][axis][place]

    void set(int place, const std::array<core::Vec3f, 3>& v) {
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis) vertex[corner][axis][place] = v[corner][axis];
    }
    core::Vec3f corner(int place, int i) const {
        return {vertex[i][0][place], vertex[i][1][place], vertex[i][2][place]};
    }

    // Calls found(hit) where the ray meets any of the triangles from place `first` on, as many as there are lanes. Most
    // packs are missed by most rays: the exact areas, and how far along the ray, are asked only where one is not.
    template<class Lanes, class Found>
    void intersect(const TriangleRay<Lanes, UniformAxes>& ray, int first, Found&& found) const {
        const auto load = [&](int corner) {
            const auto axis = [&](int k) { return Lanes::load_aligned(vertex[corner][k] + first); };
            return core::Vec3<Lanes>(axis(ray.axes.x), axis(ray.axes.y), axis(ray.axes.z));
        };
        const core::Vec3<Lanes> a = load(0), b = load(1), c = load(2);
        if (!xsimd::any(ray.cross(a, b, c).inside)) return;
        found(ray.hit(ray.exactCross(a, b, c), a, b, c));
    }
};
struct TrianglePack : TrianglePackOf<packWidth> {
    template<class Found>
    void intersect(const PackRay& ray, Found&& found) const {
        TrianglePackOf::intersect<PackLanes>(ray, 0, found);
    }
};

}  // namespace gr
