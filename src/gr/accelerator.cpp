#include "gr/accelerator.h"

#include "gr/scene.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace gr {
namespace {

struct Row {
    core::Word name;
    std::unique_ptr<Accelerator> (*make)(const Scene& scene, Objects objects, int threads, bool manyRays);
};

constexpr std::array<Row, 5> rows{{
    {"off", [](const Scene& scene, Objects objects, int, bool) { return makeNoAccelerator(scene, objects); }},
    {"on", [](const Scene& s, Objects objects, int threads, bool) { return makeGridAccelerator(s, objects, threads); }},
    {"grid",
     [](const Scene& s, Objects objects, int threads, bool) { return makeGridAccelerator(s, objects, threads); }},
    {"embree",
     [](const Scene& s, Objects objects, int threads, bool) { return makeEmbreeAccelerator(s, objects, threads); }},
    {"auto", makeFastestAccelerator},
}};

}  // namespace

namespace {

std::vector<std::uint32_t> allOf(const Scene& scene) {
    std::vector<std::uint32_t> all(scene.instances.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

// Whether testing every object is fastest: docs/performance.md tells how that was measured.
bool isFew(const Scene& scene, Objects objects, bool manyRays) {
    // One ray is tested against four objects before a tree's first box is.
    if (!manyRays) return scene.objectCount() <= 20;
    std::size_t count = 0;
    for (const std::uint32_t i : objects) {
        const auto* polyhedron = std::get_if<const Polyhedron*>(&scene.instances[i].shape);
        count += polyhedron != nullptr ? (*polyhedron)->triangleCount() : 1;
    }
    return count <= 16;
}

}  // namespace

std::unique_ptr<Accelerator> makeNoAccelerator(const Scene& scene) {
    return makeNoAccelerator(scene, allOf(scene));
}

// Few objects are tested before a tree's first box is; a grid is the fastest where objects lie evenly; else many are
// found best by Embree, where it is installed.
std::unique_ptr<Accelerator> makeFastestAccelerator(const Scene& scene, Objects objects, int threads, bool manyRays) {
    std::unique_ptr<Accelerator> fastest;
    std::string reason = "chosen for " + std::to_string(scene.objectCount()) + " objects";
    if (isFew(scene, objects, manyRays)) {
        fastest = makeNoAccelerator(scene, objects);
    } else if (!manyRays && (fastest = makeEvenGrid(scene, objects, threads)) != nullptr) {
        reason += " that lie evenly";
    } else if (isEmbreeInstalled()) {
        fastest = makeEmbreeAccelerator(scene, objects, threads);
    } else {
        fastest = makeGridAccelerator(scene, objects, threads);
        reason += ", as Embree is not installed";
    }
    fastest->reason = reason;
    return fastest;
}

std::span<const core::Word> acceleratorNames() {
    static const auto names = [] {
        std::array<core::Word, rows.size()> names;
        std::transform(rows.begin(), rows.end(), names.begin(), [](const Row& row) { return row.name; });
        return names;
    }();
    return names;
}

std::unique_ptr<Accelerator> makeAccelerator(core::Word name, const Scene& scene, int threads, bool manyRays) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
    return row->make(scene, manyRays ? scene.bodies : allOf(scene), threads, manyRays);
}

}  // namespace gr
