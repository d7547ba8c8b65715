#include "gr/triangle_order.h"

#include "core/parallel.h"
#include "gr/pack.h"
#include "gr/parts.h"

#include <algorithm>

namespace gr {
namespace {

struct Entry {
    core::Vec3f centre;
    int triangle;
};
using Entries = std::span<Entry>;

// The middle of the box of centres along its longest side, in whole packs.
std::size_t split(Entries entries) {
    core::Bounds box;
    for (const Entry& entry : entries) box.include(entry.centre);
    const core::Vec3f size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t packs = (entries.size() + packWidth - 1) / packWidth, middle = packs / 2 * packWidth;
    std::nth_element(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(middle), entries.end(),
                     [axis](const Entry& a, const Entry& b) {
                         return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis]
                                                                 : a.triangle < b.triangle;
                     });
    return middle;
}

// Halves, and halves of halves, down to packs.
void sort(Entries entries) {
    if (entries.size() <= packWidth) return;
    const std::size_t middle = split(entries);
    const auto half = [&](int i) { sort(i == 0 ? entries.first(middle) : entries.subspan(middle)); };
    constexpr std::size_t many = 1 << 15;
    if (entries.size() > many) return core::parallelFor(2, core::threadCount(0), half);
    half(0);
    half(1);
}

}  // namespace

void sortIntoPacks(const FlatMesh& mesh, std::vector<glm::ivec3>& triangles) {
    std::vector<Entry> entries(triangles.size());
    inParts(static_cast<int>(triangles.size()), [&](int first, int end) {
        for (int i = first; i < end; ++i) {
            core::Bounds box;
            for (int k = 0; k < 3; ++k) box.include(core::Vec3f(mesh.vertices[mesh.corners[triangles[i][k]]]));
            entries[i] = {(box.low + box.high) * 0.5f, i};
        }
    });
    sort(entries);
    std::vector<glm::ivec3> sorted(triangles.size());
    std::transform(entries.begin(), entries.end(), sorted.begin(),
                   [&](const Entry& entry) { return triangles[entry.triangle]; });
    triangles = std::move(sorted);
}

}  // namespace gr
