#include "gr/mesh/triangle_order.h"

#include "core/parallel.h"
#include "gr/mesh/pack.h"
#include "gr/mesh/parts.h"

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

core::Bounds boxOf(const FlatMesh& mesh, const glm::ivec3& triangle) {
    core::Bounds box;
    for (int k = 0; k < 3; ++k) box.include(core::Vec3f(mesh.vertices[mesh.corners[triangle[k]]]));
    return box;
}

// Whether packs have smaller boxes than their triangles have together, as in most files: neighbours follow each other.
bool isSorted(const FlatMesh& mesh, const std::vector<glm::ivec3>& triangles) {
    constexpr double muchSmaller = 0.75;
    const auto surface = [](const core::Bounds& box) {
        const glm::dvec3 size = box.size();
        return size.x * size.y + size.y * size.z + size.z * size.x;
    };
    struct Sum {
        double ofPacks = 0, ofTriangles = 0;
    };
    const int count = static_cast<int>(triangles.size());
    static_assert(partSize % packWidth == 0);
    const std::vector<Sum> sums = ofParts<Sum>(count, [&](int begin, int end) {
        Sum sum;
        for (int first = begin; first < end; first += packWidth) {
            core::Bounds pack;
            for (int i = first; i < std::min(first + packWidth, end); ++i) {
                const core::Bounds box = boxOf(mesh, triangles[i]);
                pack.include(box);
                sum.ofTriangles += surface(box);
            }
            sum.ofPacks += surface(pack);
        }
        return sum;
    });
    Sum all;
    for (const Sum& sum : sums) {
        all.ofPacks += sum.ofPacks;
        all.ofTriangles += sum.ofTriangles;
    }
    return all.ofPacks <= muchSmaller * all.ofTriangles;
}

}  // namespace

void sortIntoPacks(const FlatMesh& mesh, std::vector<glm::ivec3>& triangles) {
    if (isSorted(mesh, triangles)) return;
    std::vector<Entry> entries(triangles.size());
    inParts(static_cast<int>(triangles.size()), [&](int first, int end) {
        for (int i = first; i < end; ++i) {
            const core::Bounds box = boxOf(mesh, triangles[i]);
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
