// The rays of a picture's paths, kept in memory, so that whoever traces them has the same ones.
#pragma once

#include "core/ray.h"
#include "scene_script.h"

#include <algorithm>
#include <vector>

namespace bench {

// As many rays as the widest lanes take, side by side.
struct alignas(64) RayPack {
    static constexpr int width = 16;
    float origin[3][width], direction[3][width], tMax[width];

    void set(int place, const core::Rayf& ray) {
        for (int axis = 0; axis < 3; ++axis) {
            origin[axis][place] = ray.origin[axis];
            direction[axis][place] = ray.direction[axis];
        }
        tMax[place] = ray.tMax;
    }
    core::Rayf at(int place) const {
        return {{origin[0][place], origin[1][place], origin[2][place]},
                {direction[0][place], direction[1][place], direction[2][place]},
                tMax[place]};
    }
    // rays: Embree's pack of as many.
    template<class Rays>
    void copyTo(Rays& rays) const {
        const auto copy = [](const float* from, float* to) { std::copy(from, from + width, to); };
        const auto fill = [](auto* to, auto value) { std::fill(to, to + width, value); };
        copy(origin[0], rays.org_x), copy(origin[1], rays.org_y), copy(origin[2], rays.org_z);
        copy(direction[0], rays.dir_x), copy(direction[1], rays.dir_y), copy(direction[2], rays.dir_z);
        copy(tMax, rays.tfar);
        fill(rays.tnear, 0.f), fill(rays.time, 0.f);
        fill(rays.mask, ~0u), fill(rays.id, 0u), fill(rays.flags, 0u);
    }
    // Those from place `first` on, as many as there are lanes.
    template<class Lanes>
    core::Ray<Lanes> lanes(int first) const {
        const auto load = [&](const float* row) { return Lanes::load_aligned(row + first); };
        return {{load(origin[0]), load(origin[1]), load(origin[2])},
                {load(direction[0]), load(direction[1]), load(direction[2])},
                load(tMax)};
    }
};

class RayPacks {
public:
    void add(const core::Rayf& ray) {
        if (count_ % RayPack::width == 0) packs_.emplace_back();
        packs_.back().set(count_++ % RayPack::width, ray);
    }
    // Leaves out the last ones where they do not fill a pack.
    void finish() {
        if (count_ % RayPack::width != 0) packs_.pop_back();
    }
    const std::vector<RayPack>& packs() const { return packs_; }
    std::size_t size() const { return packs_.size() * RayPack::width; }

private:
    std::vector<RayPack> packs_;
    int count_ = 0;
};

// camera: through random places of the pixels, in the order in which the integrator takes them. From where these meet a
// surface, shadow: to random places on the first lamp, if the two face each other; bounce: on, cosine-distributed.
struct PathRays {
    RayPacks camera, shadow, bounce;
};
PathRays raysOf(const ScriptScene& scene, const gr::Accelerator& accelerator);

}  // namespace bench
