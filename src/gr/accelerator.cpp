#include "gr/accelerator.h"

#include "gr/scene.h"

#include <algorithm>
#include <array>

namespace gr {
namespace {

struct Row {
    core::Word name;
    std::unique_ptr<Accelerator> (*make)(const Scene& scene, int threads, bool manyRays);
};

constexpr std::array<Row, 5> rows{{
    {"off", [](const Scene& scene, int, bool) { return makeNoAccelerator(scene); }},
    {"on", [](const Scene& scene, int threads, bool) { return makeGridAccelerator(scene, threads); }},
    {"grid", [](const Scene& scene, int threads, bool) { return makeGridAccelerator(scene, threads); }},
    {"embree", [](const Scene& scene, int threads, bool) { return makeEmbreeAccelerator(scene, threads); }},
    {"auto", makeFastestAccelerator},
}};

}  // namespace

namespace {

// Whether testing every object is fastest: docs/performance.md tells how that was measured.
bool isFew(const Scene& scene, bool manyRays) {
    const auto isSmooth = [](const auto& polyhedron) { return polyhedron->hasNormals(); };
    // One ray is tested against four objects before a tree's first box is.
    if (!manyRays || std::any_of(scene.polyhedra.begin(), scene.polyhedra.end(), isSmooth))
        return scene.objectCount() <= 20;
    // With many rays at once, four triangles, which may make two parallelograms, take as long as a ball or a box.
    std::size_t quarters = 0;
    for (const Instance& instance : scene.instances) {
        const auto* polyhedron = std::get_if<const Polyhedron*>(&instance.shape);
        quarters += polyhedron != nullptr ? (*polyhedron)->triangleCount() : 4;
    }
    return quarters <= 4 * 80;
}

}  // namespace

// Few objects are tested before a tree's first box is; a grid is the fastest where objects lie evenly; else many are
// found best by Embree, where it is installed.
std::unique_ptr<Accelerator> makeFastestAccelerator(const Scene& scene, int threads, bool manyRays) {
    std::unique_ptr<Accelerator> fastest;
    std::string reason = "chosen for " + std::to_string(scene.objectCount()) + " objects";
    if (isFew(scene, manyRays)) {
        fastest = makeNoAccelerator(scene);
    } else if ((fastest = makeEvenGrid(scene, threads)) != nullptr) {
        reason += " that lie evenly";
    } else if (isEmbreeInstalled()) {
        fastest = makeEmbreeAccelerator(scene, threads);
    } else {
        fastest = makeGridAccelerator(scene, threads);
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
    return row->make(scene, threads, manyRays);
}

}  // namespace gr
