// How the object is found that a ray meets first. To add a way: write its file beside
// src/gr/accelerators/grid_accelerator.cpp, declare its make function here, and add its name to the list in
// src/gr/accelerators/accelerator.cpp.
#pragma once

#include "core/option.h"
#include "core/ray.h"
#include "gr/hit.h"

#include <array>
#include <memory>
#include <optional>
#include <span>

namespace gr {

class Scene;
class ObjectTree;

// How much work rays were.
struct TraversalCounts {
    std::uint64_t tests = 0;  // of one shape or one triangle
    std::uint64_t cells = 0;  // of a grid, empty ones and whole bricks too; 0 for what is no grid

    TraversalCounts& operator+=(const TraversalCounts& other) {
        tests += other.tests;
        cells += other.cells;
        return *this;
    }
};

class Accelerator {
public:
    virtual ~Accelerator() = default;

    // The nearest hit with 0 < t < ray.tMax, of any side of any object. Every accelerator finds the same one, bit by
    // bit.
    virtual std::optional<Hit> intersect(const core::Rayf& ray, TraversalCounts& counts) const = 0;
    // Whether there is any.
    virtual bool occluded(const core::Rayf& ray, TraversalCounts& counts) const = 0;
    virtual std::size_t bytes() const = 0;
    // What it is, for a person: "grid of 12 x 8 x 3 cells".
    virtual std::string description() const = 0;
    // Itself where it is trees of boxes, else null: lanes walk those by themselves.
    virtual const ObjectTree* tree() const { return nullptr; }
    // Whether it tests every object for every ray.
    virtual bool testsAll() const { return false; }
    std::string reason;  // why it was taken, where nobody asked for it by name
    // How many cells of a grid there are along each axis, of its top level; nothing for what is no grid.
    virtual std::optional<std::array<int, 3>> resolution() const { return std::nullopt; }

    std::optional<Hit> intersect(const core::Rayf& ray) const {
        TraversalCounts counts;
        return intersect(ray, counts);
    }
    bool occluded(const core::Rayf& ray) const {
        TraversalCounts counts;
        return occluded(ray, counts);
    }
};

// The instances that an accelerator is for, by their indices.
using Objects = std::span<const std::uint32_t>;

// Tests every object. The scene must outlive what is made for it, here and below.
std::unique_ptr<Accelerator> makeNoAccelerator(const Scene& scene, Objects objects);
std::unique_ptr<Accelerator> makeNoAccelerator(const Scene& scene);  // for all of its objects
// The report's two-level uniform grid. threads: to build it with; 0: all cores.
std::unique_ptr<Accelerator> makeGridAccelerator(const Scene& scene, Objects objects, int threads);
// The same where it is at its best: where nearly each object has a cell for itself, as in a lattice. Else null.
std::unique_ptr<Accelerator> makeEvenGrid(const Scene& scene, Objects objects, int threads);
// Trees of boxes, built by Embree. Throws core::Error where Embree cannot be loaded.
std::unique_ptr<Accelerator> makeEmbreeAccelerator(const Scene& scene, Objects objects, int threads);
bool isEmbreeInstalled();

// Of the three the one that is fastest for the objects; it says why. manyRays: many rays at once are tested.
std::unique_ptr<Accelerator> makeFastestAccelerator(const Scene& scene, Objects objects, int threads, bool manyRays);

// What an accelerator may be called.
std::span<const core::Word> acceleratorNames();
// name: one of them. manyRays: it is for gr::Tracer, which tests many rays at once, and the flat faces of a scene by
// itself; else for one ray at a time and for all objects.
std::unique_ptr<Accelerator> makeAccelerator(core::Word name, const Scene& scene, int threads, bool manyRays = false);

}  // namespace gr
