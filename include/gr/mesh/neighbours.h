// Which faces of a mesh share an edge.
#pragma once

#include "gr/mesh/parts.h"
#include "gr/mesh/polyhedron.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace gr {

// For each edge of each face, the face beyond it. An edge has a place in FlatMesh::corners: where it starts.
class Neighbours {
public:
    static constexpr int none = -1;  // the edge belongs to one face only, or to more than two

    explicit Neighbours(const FlatMesh& mesh)
        : beyond_(std::make_unique_for_overwrite<int[]>(mesh.corners.size())), starts_(mesh.vertices.size() + 1) {
        collect(mesh);
        inParts(mesh.faceCount(), [&](int first, int end) {
            for (int f = first; f < end; ++f)
                forEachEdge(mesh, f, [&](int place, int a, int b) { beyond_[place] = find(f, a, b); });
        });
        starts_ = {};
        edges_.reset();
    }

    int face(int place) const { return beyond_[place] >> 1; }
    // Whether both faces run along the edge in the same way: then one of them is the wrong way round.
    bool runsAlike(int place) const { return (beyond_[place] & 1) != 0; }

private:
    // An edge of a face, kept with the vertex that it starts from.
    struct Edge {
        int to;
        int face;
        bool operator<(const Edge& other) const { return to != other.to ? to < other.to : face < other.face; }
    };

    template<class Function>
    static void forEachEdge(const FlatMesh& mesh, int f, Function&& function) {
        const int begin = mesh.begin(f), end = mesh.end(f);
        for (int i = begin; i < end; ++i) function(i, mesh.corners[i], mesh.corners[i + 1 < end ? i + 1 : begin]);
    }

    // Sorts the edges by where they start; where many do, as at the tip of a cone, by where they go as well.
    void collect(const FlatMesh& mesh) {
        for (const int a : mesh.corners) ++starts_[a];
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        edges_ = std::make_unique_for_overwrite<Edge[]>(mesh.corners.size());
        // Filled from behind, which leaves in starts_ where each vertex's edges start.
        for (int f = 0; f < mesh.faceCount(); ++f)
            forEachEdge(mesh, f, [&](int, int a, int b) { edges_[--starts_[a]] = {b, f}; });
        inParts(static_cast<int>(mesh.vertices.size()), [&](int first, int end) {
            for (int a = first; a < end; ++a)
                if (starts_[a + 1] - starts_[a] > many) std::sort(&edges_[starts_[a]], &edges_[starts_[a + 1]]);
        });
    }

    // Calls function(face) for the faces with an edge from a to b until it returns false.
    template<class Function>
    void forEachFrom(int a, int b, Function&& function) const {
        const Edge* edge = &edges_[starts_[a]];
        const Edge* end = &edges_[starts_[a + 1]];
        const bool isSorted = end - edge > many;
        if (isSorted) edge = std::lower_bound(edge, end, Edge{b, 0});
        for (; edge != end && (!isSorted || edge->to == b); ++edge)
            if (edge->to == b && !function(edge->face)) return;
    }

    // The face beyond the edge of face f from a to b, times two, plus one where it runs alike.
    int find(int f, int a, int b) const {
        int found = none, uses = 0;
        bool isOwnSeen = false;
        forEachFrom(a, b, [&](int face) {
            const bool isOwn = face == f && !isOwnSeen;
            isOwnSeen |= isOwn;
            if (!isOwn) found = 2 * face + 1;
            return ++uses <= 2;
        });
        forEachFrom(b, a, [&](int face) {
            found = 2 * face;
            return ++uses <= 2;
        });
        return uses == 2 ? found : none;
    }

    static constexpr int many = 32;

    std::unique_ptr<int[]> beyond_;  // what find returns, for each place
    std::vector<int> starts_;  // where a vertex's edges start in edges_
    std::unique_ptr<Edge[]> edges_;
};

}  // namespace gr
