// Which way faces face.
#include "gr/mesh/mesh_repair.h"
#include "gr/mesh/parts.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace gr {
namespace {

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

// Six times the volume that the faces of a closed body enclose: positive when they face outwards.
double volume(const FlatMesh& mesh, std::span<const int> faces, const std::vector<char>& turned) {
    const glm::dvec3 origin = mesh.vertices[mesh.corners[mesh.begin(faces[0])]];
    const std::vector<double> sums = ofParts<double>(static_cast<int>(faces.size()), [&](int first, int end) {
        double sum = 0;
        for (const int f : faces.subspan(first, end - first)) {
            const std::span<const int> face = mesh.face(f);
            const double cone = glm::dot(faceNormal(mesh.vertices, face), mesh.vertices[face[0]] - origin);
            sum += turned[f] ? -cone : cone;
        }
        return sum;
    });
    return std::accumulate(sums.begin(), sums.end(), 0.);
}

void turn(FlatMesh& mesh, int face) {
    const int begin = mesh.begin(face), end = mesh.end(face);
    mesh.forEachCornerList([&](auto& list) { std::reverse(list.begin() + begin, list.begin() + end); });
}

}  // namespace

void orientFaces(FlatMesh& mesh, MeshRepairs& repairs) {
    const Neighbours neighbours(mesh);
    const int count = mesh.faceCount();
    std::vector<char> seen(count, 0), turned(count, 0);
    std::vector<int> body;
    body.reserve(count);
    for (int start = 0; start < count; ++start) {
        if (seen[start]) continue;
        // Walk over shared edges: two faces agree when they run along their edge in opposite ways.
        body.assign(1, start);
        bool closed = true;
        seen[start] = 1;
        for (std::size_t next = 0; next < body.size(); ++next) {
            const int f = body[next];
            for (int place = mesh.begin(f); place < mesh.end(f); ++place) {
                const int other = neighbours.face(place);
                closed &= other != Neighbours::none;
                if (other == Neighbours::none || seen[other]) continue;
                seen[other] = 1;
                turned[other] = static_cast<char>(neighbours.runsAlike(place) != (turned[f] != 0));
                body.push_back(other);
            }
        }
        // A closed body faces outwards; of an open one the fewer faces are wrong.
        const auto turnedCount = std::count_if(body.begin(), body.end(), [&](int f) { return turned[f]; });
        const bool inverted =
            closed ? volume(mesh, body, turned) < 0 : 2 * turnedCount > static_cast<std::ptrdiff_t>(body.size());
        for (const int f : body) turned[f] = static_cast<char>((turned[f] != 0) != inverted);
    }
    // Edges had to stay where they are until now.
    for (int f = 0; f < count; ++f) {
        if (!turned[f]) continue;
        turn(mesh, f);
        ++repairs.turnedFaces;
    }
}

}  // namespace gr
