// Which way faces face.
#include "gr/mesh/mesh_repair.h"
#include "gr/mesh/neighbours.h"
#include "gr/mesh/nesting.h"

#include <algorithm>
#include <numeric>

namespace gr {
namespace {

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

// Lets each closed body face the right way: sets which faces have to be turned.
class Bodies {
public:
    Bodies(const FlatMesh& mesh, std::vector<char>& turned) : mesh_(mesh), turned_(turned) {
        faces_.reserve(turned.size());
    }

    // Adds the body that face `start` belongs to, seen: the faces of those so far.
    void add(int start, const Neighbours& neighbours, std::vector<char>& seen) {
        const std::size_t first = faces_.size();
        const bool isClosed = walk(start, neighbours, seen);
        const std::span<const int> body = std::span(faces_).subspan(first);
        const auto size = static_cast<std::ptrdiff_t>(body.size());
        const auto turned = std::count_if(body.begin(), body.end(), [&](int f) { return turned_[f] != 0; });
        if (isClosed) {
            const double twice = volume(mesh_, body, turned_);
            solids_.push_back({body, std::abs(twice)});
            isWalkedInwards_.push_back(twice < 0);
            isFiledOutwards_.push_back(2 * (twice < 0 ? size - turned : turned) <= size);
        } else {
            if (2 * turned > size) invert(body);  // the fewer are wrong
            faces_.resize(first);
        }
    }

    // To be called once, after all were added. A body faces outwards; but if it lies in another, and the file winds it
    // the other way round than the outermost round it, and there is something of it to be taken away, it bounds a
    // cavity.
    void orient() {
        const std::vector<int> around = enclosing(mesh_, solids_);
        std::vector<int> bySize(solids_.size());
        std::iota(bySize.begin(), bySize.end(), 0);
        std::stable_sort(bySize.begin(), bySize.end(),
                         [&](int a, int b) { return solids_[a].volume > solids_[b].volume; });
        std::vector<char> isFileInsideOut(solids_.size());
        std::vector<int> depth(solids_.size());  // how many bodies hold what is just within, less cavities
        for (const int solid : bySize) {
            const int outer = around[solid];
            const bool isFiledOutwards = isFiledOutwards_[solid] != 0;
            isFileInsideOut[solid] = static_cast<char>(outer < 0 ? !isFiledOutwards : isFileInsideOut[outer] != 0);
            const int within = outer < 0 ? 0 : depth[outer];
            const bool facesOutwards = within == 0 || isFiledOutwards != (isFileInsideOut[solid] != 0);
            depth[solid] = within + (facesOutwards ? 1 : -1);
            if ((isWalkedInwards_[solid] != 0) == facesOutwards) invert(solids_[solid].faces);
        }
    }

private:
    // Appends all faces that hang together with one, turned so that they agree with it, and tells whether they close a
    // body. Two faces agree when they run along their edge in opposite ways.
    bool walk(int start, const Neighbours& neighbours, std::vector<char>& seen) {
        bool isClosed = true;
        seen[start] = 1;
        std::size_t next = faces_.size();
        for (faces_.push_back(start); next < faces_.size(); ++next) {
            const int f = faces_[next];
            for (int place = mesh_.begin(f); place < mesh_.end(f); ++place) {
                const int other = neighbours.face(place);
                isClosed &= other != Neighbours::none;
                if (other == Neighbours::none || seen[other]) continue;
                seen[other] = 1;
                turned_[other] = static_cast<char>(neighbours.runsAlike(place) != (turned_[f] != 0));
                faces_.push_back(other);
            }
        }
        return isClosed;
    }

    void invert(std::span<const int> faces) {
        for (const int f : faces) turned_[f] = static_cast<char>(turned_[f] == 0);
    }

    const FlatMesh& mesh_;
    std::vector<char>& turned_;
    std::vector<int> faces_;  // of the closed bodies; never moved
    std::vector<Solid> solids_;
    std::vector<char> isWalkedInwards_;  // whether one faces inwards with turned_ as the walk left it
    std::vector<char> isFiledOutwards_;  // whether no more than half of one's faces face inwards as they came
};

}  // namespace

void orientFaces(FlatMesh& mesh, MeshRepairs& repairs) {
    const int count = mesh.faceCount();
    std::vector<char> turned(count, 0);
    {
        const Neighbours neighbours(mesh);
        std::vector<char> seen(count, 0);
        Bodies bodies(mesh, turned);
        for (int start = 0; start < count; ++start)
            if (seen[start] == 0) bodies.add(start, neighbours, seen);
        bodies.orient();
    }
    // Edges had to stay where they are until now.
    for (int f = 0; f < count; ++f) {
        if (turned[f] == 0) continue;
        turn(mesh, f);
        ++repairs.turnedFaces;
    }
}

}  // namespace gr
