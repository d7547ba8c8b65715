#include "gr/accelerator.h"

#include "gr/scene.h"

#include <algorithm>
#include <array>

namespace gr {
namespace {

struct Row {
    core::Word name;
    std::unique_ptr<Accelerator> (*make)(const Scene& scene, int threads, std::size_t few);
};

constexpr std::array<Row, 5> rows{{
    {"off", [](const Scene& scene, int, std::size_t) { return makeNoAccelerator(scene); }},
    {"on", [](const Scene& scene, int threads, std::size_t) { return makeGridAccelerator(scene, threads); }},
    {"grid", [](const Scene& scene, int threads, std::size_t) { return makeGridAccelerator(scene, threads); }},
    {"embree", [](const Scene& scene, int threads, std::size_t) { return makeEmbreeAccelerator(scene, threads); }},
    {"auto", makeFastestAccelerator},
}};

}  // namespace

// docs/performance.md tells how that was measured: few objects are tested before a tree's first box is; a grid is the
// fastest where objects lie evenly; else many are found best by Embree, where it is installed.
std::unique_ptr<Accelerator> makeFastestAccelerator(const Scene& scene, int threads, std::size_t few) {
    std::unique_ptr<Accelerator> fastest;
    std::string reason = "chosen for " + std::to_string(scene.objectCount()) + " objects";
    if (scene.objectCount() <= few) {
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

std::unique_ptr<Accelerator> makeAccelerator(core::Word name, const Scene& scene, int threads, std::size_t few) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
    return row->make(scene, threads, few);
}

}  // namespace gr
