#include "gr/accelerator.h"

#include <algorithm>
#include <array>

namespace gr {
namespace {

struct Row {
    core::Word name;
    std::unique_ptr<Accelerator> (*make)(const Scene& scene, int threads);
};

constexpr std::array<Row, 4> rows{{
    {"off", [](const Scene& scene, int) { return makeNoAccelerator(scene); }},
    {"on", makeGridAccelerator},
    {"grid", makeGridAccelerator},
    {"embree", makeEmbreeAccelerator},
}};

}  // namespace

std::span<const core::Word> acceleratorNames() {
    static const auto names = [] {
        std::array<core::Word, rows.size()> names;
        std::transform(rows.begin(), rows.end(), names.begin(), [](const Row& row) { return row.name; });
        return names;
    }();
    return names;
}

std::unique_ptr<Accelerator> makeAccelerator(core::Word name, const Scene& scene, int threads) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
    return row->make(scene, threads);
}

}  // namespace gr
