#include "gr/mesh/nesting.h"

#include "gr/mesh/box_tree.h"

#include <array>

namespace gr {
namespace {

Box boxOf(const FlatMesh& mesh, std::span<const int> faces) {
    Box box;
    for (const int f : faces)
        for (const int v : mesh.face(f)) box.include(mesh.vertices[v]);
    return box;
}

// Along +x. A ray through an edge or a vertex must cross just one of the triangles there, so where it runs through an
// edge, it is taken to pass by a little further along y, and by far less along z (as MeshLine has it): for each edge
// that is one and the same side in all triangles that share it.
class Ray {
public:
    explicit Ray(const glm::dvec3& origin) : origin_(origin) {}

    bool mayMeet(const Box& box) const {
        return box.low.y <= origin_.y && origin_.y <= box.high.y && box.low.z <= origin_.z && origin_.z <= box.high.z &&
               origin_.x <= box.high.x;
    }

    // Whether it crosses a face an odd number of times. Of triangles that fan out from one corner, overlapping or not,
    // just those places are covered an odd number of times that the outline runs round.
    bool crosses(const FlatMesh& mesh, int face) const {
        const std::span<const int> corners = mesh.face(face);
        const auto place = [&](std::size_t i) { return mesh.vertices[corners[i]] - origin_; };
        bool isOdd = false;
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) isOdd ^= crosses(place(0), place(i), place(i + 1));
        return isOdd;
    }

private:
    static bool crosses(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const int side = sideOf(a, b);
        if (side == 0 || sideOf(b, c) != side || sideOf(c, a) != side) return false;
        const glm::dvec3 shares(area(b, c), area(c, a), area(a, b));
        const double x = glm::dot(shares, glm::dvec3(a.x, b.x, c.x));
        return side > 0 ? x > 0 : x < 0;
    }
    // Twice that of the triangle that the ray, end-on, and the edge make.
    static double area(const glm::dvec3& a, const glm::dvec3& b) { return a.y * b.z - a.z * b.y; }
    // On which side of an edge the ray passes; 0 where that is seen end-on.
    static int sideOf(const glm::dvec3& a, const glm::dvec3& b) {
        const auto sign = [](double x, double y) { return x > y ? 1 : x < y ? -1 : 0; };
        if (const int side = sign(a.y * b.z, a.z * b.y)) return side;
        if (const int side = sign(a.z, b.z)) return side;
        return sign(b.y, a.y);
    }

    glm::dvec3 origin_;
};

class Nest {
public:
    Nest(const FlatMesh& mesh, std::span<const Solid> solids) : mesh_(mesh), solids_(solids) {
        for (const Solid& solid : solids) boxes_.push_back(boxOf(mesh, solid.faces));
    }

    std::vector<int> enclosing() const {
        std::vector<int> found(solids_.size(), -1), inner;
        std::vector<char> isOuter(solids_.size(), 0);
        const BoxTree tree(boxes_);
        for (int i = 0; i < static_cast<int>(solids_.size()); ++i) {
            bool isInner = false;
            tree.forEach([&](const Box& box) { return box.holds(boxes_[i]); },
                         [&](int outer) {
                             if (!mayHold(outer, i)) return;
                             isOuter[outer] = 1;
                             isInner = true;
                         });
            if (isInner) inner.push_back(i);
        }
        if (inner.empty()) return found;
        const Faces faces(*this, isOuter);
        for (const int i : inner) found[i] = faces.smallestRound(i);
        return found;
    }

private:
    // Of two solids at one place none holds the other.
    bool mayHold(int outer, int inner) const {
        return solids_[outer].volume > solids_[inner].volume && boxes_[outer].holds(boxes_[inner]);
    }

    // The faces of all solids that may hold others.
    class Faces {
    public:
        Faces(const Nest& nest, const std::vector<char>& isOuter) : nest_(nest), tree_(collect(isOuter)) {}

        int smallestRound(int inner) const {
            const std::span<const int> own = nest_.solids_[inner].faces;
            std::vector<int> votes;
            for (const std::size_t third : {0, 1, 2}) addRound(own[third * own.size() / 3], inner, votes);
            std::sort(votes.begin(), votes.end());
            int smallest = -1;
            // Of three votes two are enough.
            for (std::size_t i = 1; i < votes.size(); ++i)
                if (votes[i] == votes[i - 1] &&
                    (smallest < 0 || nest_.solids_[votes[i]].volume < nest_.solids_[smallest].volume))
                    smallest = votes[i];
            return smallest;
        }

    private:
        std::vector<Box> collect(const std::vector<char>& isOuter) {
            std::vector<Box> boxes;
            for (int i = 0; i < static_cast<int>(isOuter.size()); ++i) {
                if (isOuter[i] == 0) continue;
                for (const int f : nest_.solids_[i].faces) {
                    faces_.push_back({f, i});
                    boxes.push_back(boxOf(nest_.mesh_, {&f, 1}));
                }
            }
            return boxes;
        }

        // Appends the solids that hold the first vertex of a face.
        void addRound(int face, int inner, std::vector<int>& solids) const {
            const Ray ray(nest_.mesh_.vertices[nest_.mesh_.face(face)[0]]);
            std::vector<int> crossed;
            tree_.forEach([&](const Box& box) { return ray.mayMeet(box); },
                          [&](int i) {
                              if (ray.crosses(nest_.mesh_, faces_[i].number)) crossed.push_back(faces_[i].solid);
                          });
            std::sort(crossed.begin(), crossed.end());
            for (auto run = crossed.begin(); run != crossed.end();) {
                const auto end = std::upper_bound(run, crossed.end(), *run);
                if ((end - run) % 2 == 1 && nest_.mayHold(*run, inner)) solids.push_back(*run);
                run = end;
            }
        }

        struct Face {
            int number, solid;
        };

        const Nest& nest_;
        std::vector<Face> faces_;
        BoxTree tree_;
    };

    const FlatMesh& mesh_;
    std::span<const Solid> solids_;
    std::vector<Box> boxes_;
};

}  // namespace

std::vector<int> enclosing(const FlatMesh& mesh, std::span<const Solid> solids) {
    if (solids.size() < 2) return std::vector<int>(solids.size(), -1);
    return Nest(mesh, solids).enclosing();
}

}  // namespace gr
