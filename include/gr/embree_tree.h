// A tree of boxes that Embree builds and walks. What is in the boxes stays ours, so that Embree's tree finds what every
// other accelerator finds, bit by bit.
#pragma once

#include "core/bounds.h"
#include "gr/accelerator.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace gr {

// Loads the library when the first one is made: it is so large that every start of the program would feel it.
class EmbreeDevice {
public:
    EmbreeDevice();  // throws core::Error where Embree cannot be loaded
    ~EmbreeDevice();
    EmbreeDevice(const EmbreeDevice&) = delete;
    EmbreeDevice& operator=(const EmbreeDevice&) = delete;

    RTCDeviceTy* get() const { return device_; }
    std::size_t bytes() const { return static_cast<std::size_t>(bytes_.load()); }
    void check() const;  // throws what went wrong since the last time

private:
    RTCDeviceTy* device_ = nullptr;
    std::atomic<std::ptrdiff_t> bytes_{0};
};

class EmbreeTree {
public:
    using BoundsOf = std::function<core::Bounds(std::uint32_t)>;

    // boundsOf: of the items 0 to count - 1. They must hold every point at which an item may be reported to be hit by a
    // ray that starts at the origin; one that starts or hits at distance x from there may be off by errorPerUnit * x
    // more. The device must outlive the tree. threads: to build it with.
    EmbreeTree(const EmbreeDevice& device, std::uint32_t count, BoundsOf boundsOf, float errorPerUnit, int threads);
    ~EmbreeTree();

    // Calls visit(item) for the items near the ray until it returns true, or nothing nearer than `nearest`, which visit
    // may lower, can follow. Every item that the ray hits at most as far as `nearest` is visited.
    template<class Visit>
    void walk(const core::Rayf& ray, const float& nearest, TraversalCounts&, Visit&& visit) const {
        const auto call = [](void* visit, std::uint32_t item) {
            return (*static_cast<std::remove_reference_t<Visit>*>(visit))(item);
        };
        walk(ray, nearest, call, &visit);
    }

private:
    using Call = bool (*)(void* visit, std::uint32_t item);
    struct Walk;

    // The boxes as they are for rays from so far away: the farther, the more is rounded, and the wider they must be.
    struct Shell {
        std::once_flag isMade;
        RTCSceneTy* scene = nullptr;
    };

    void walk(const core::Rayf& ray, const float& nearest, Call call, void* visit) const;
    RTCSceneTy* sceneFor(float distance) const;
    RTCSceneTy* make(float widening) const;

    const EmbreeDevice& device_;
    std::uint32_t count_;
    BoundsOf boundsOf_;
    float errorPerUnit_;
    int threads_;
    float reach_ = 0;  // the items' largest coordinate
    float scale_ = 1;  // a power of two that makes it about 1: Embree has limits of its own
    // The nearest is made at once, the others when a ray comes from there.
    mutable std::array<Shell, 4> shells_;
};

}  // namespace gr
