#include "core/error.h"
#include "gr/mesh/mesh_repair.h"

#include <algorithm>

namespace gr {
namespace {

using Outline = std::vector<glm::dvec2>;  // counter-clockwise

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

// Twice the area of a, b, c: positive when they turn left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return cross(b - a, c - a);
}

// Looks at the face along its normal's largest axis, from the side from which it runs counter-clockwise.
Outline project(const std::vector<glm::dvec3>& vertices, std::span<const int> face, const glm::dvec3& normal) {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    int x = (axis + 1) % 3, y = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(x, y);
    Outline outline;
    for (const int v : face)
        outline.emplace_back(vertices[v][x] - vertices[face[0]][x], vertices[v][y] - vertices[face[0]][y]);
    return outline;
}

bool segmentsCross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

// Sweeps over the edges from left to right, so that only those that overlap in x are compared.
bool crossesItself(const Outline& outline) {
    struct Edge {
        glm::dvec2 a, b;
        double left, right;
    };
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        edges.push_back({a, b, std::min(a.x, b.x), std::max(a.x, b.x)});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.left < b.left; });
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size() && edges[j].left <= edges[i].right; ++j)
            if (segmentsCross(edges[i].a, edges[i].b, edges[j].a, edges[j].b)) return true;
    return false;
}

// Whether the triangle round corner i of what is left of the outline can be cut off: it turns left, and no other
// corner lies in it. A corner at the same place as one of the triangle's does not count.
bool isEar(const Outline& outline, const std::vector<int>& left, std::size_t i) {
    const std::size_t n = left.size();
    const glm::dvec2 a = outline[left[(i + n - 1) % n]], b = outline[left[i]], c = outline[left[(i + 1) % n]];
    if (turn(a, b, c) <= 0) return false;
    for (const int other : left) {
        const glm::dvec2 p = outline[other];
        if (p == a || p == b || p == c) continue;
        if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
}

// Whether nothing with an area is left to cut off.
bool isFlat(const Outline& outline, const std::vector<int>& left) {
    for (std::size_t i = 1; i + 1 < left.size(); ++i)
        if (turn(outline[left[0]], outline[left[i]], outline[left[i + 1]]) != 0) return false;
    return true;
}

// Ear clipping (Meisters 1975: every simple outline of more than three corners has two ears). Of a
// convex outline this makes a fan. False when there is no ear: the outline is not simple.
bool clipEars(const Outline& outline, std::vector<glm::ivec3>& triangles) {
    std::vector<int> left(outline.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = static_cast<int>(i);
    std::size_t at = 0, tried = 0;
    while (left.size() >= 3) {
        const std::size_t n = left.size();
        at %= n;
        if (isEar(outline, left, at)) {
            triangles.emplace_back(left[(at + n - 1) % n], left[at], left[(at + 1) % n]);
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
            tried = 0;
        } else if (++at, ++tried == n) {
            return isFlat(outline, left);
        }
    }
    return true;
}

// The triangles of one face as numbers of its corners. False when its outline is not simple.
bool cut(const std::vector<glm::dvec3>& vertices, std::span<const int> face, std::vector<glm::ivec3>& triangles) {
    // An outline whose areas cancel, a bow tie, has no side to be looked at from.
    const glm::dvec3 normal = faceNormal(vertices, face);
    if (normal == glm::dvec3(0)) return false;
    const Outline outline = project(vertices, face, normal);
    return !crossesItself(outline) && clipEars(outline, triangles);
}

[[noreturn]] void throwCrossing(std::span<const int> face) {
    std::string words;
    for (const int v : face) {
        if (!words.empty()) words += ' ';
        words += std::to_string(v);
    }
    throw core::Error("MESH", "CROSSING", words, "the outline of face {" + words + "} crosses itself");
}

}  // namespace

std::vector<glm::ivec3> triangulate(const FlatMesh& mesh, Crossing crossing, MeshRepairs& repairs) {
    std::vector<glm::ivec3> triangles;
    triangles.reserve(mesh.corners.size() - 2 * static_cast<std::size_t>(mesh.faceCount()));
    std::vector<glm::ivec3> ofFace;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int begin = mesh.begin(f);
        if (mesh.end(f) - begin == 3) {
            triangles.emplace_back(begin, begin + 1, begin + 2);
            continue;
        }
        ofFace.clear();
        if (cut(mesh.vertices, mesh.face(f), ofFace)) {
            for (const glm::ivec3& triangle : ofFace) triangles.push_back(triangle + begin);
        } else {
            if (crossing == Crossing::isAnError) throwCrossing(mesh.face(f));
            ++repairs.crossingFaces;
        }
    }
    return triangles;
}

}  // namespace gr
