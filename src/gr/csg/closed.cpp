#include "gr/csg/closed.h"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

namespace gr {
namespace {

// Triangles share a vertex where it is at the same place; -0 is 0.
using Place = std::array<std::uint32_t, 3>;

Place placeOf(const core::Vec3f& v) {
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x + 0.f); };
    return {bits(v.x), bits(v.y), bits(v.z)};
}

struct Edge {
    Place low, high;
    int way;  // 1 from low to high, or -1

    bool isAlong(const Edge& other) const { return low == other.low && high == other.high; }
    bool operator<(const Edge& other) const { return std::tie(low, high) < std::tie(other.low, other.high); }
};

}  // namespace

std::size_t openEdges(const Polyhedron& mesh) {
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangleCount());
    for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i)
        for (int k = 0; k < 3; ++k) {
            const Place a = placeOf(mesh.vertex(i, k)), b = placeOf(mesh.vertex(i, (k + 1) % 3));
            if (a != b) edges.push_back(a < b ? Edge{a, b, 1} : Edge{b, a, -1});
        }
    std::sort(edges.begin(), edges.end());
    std::size_t open = 0;
    for (std::size_t i = 0; i < edges.size();) {
        int sum = 0;
        const Edge& first = edges[i];
        for (; i < edges.size() && edges[i].isAlong(first); ++i) sum += edges[i].way;
        open += sum != 0;
    }
    return open;
}

}  // namespace gr
