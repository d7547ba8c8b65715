#include "gr/mesh_repair.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace gr {

glm::dvec3 faceNormal(const PolygonMesh& mesh, const std::vector<int>& face) {
    // About the first vertex, so that a small face far from the origin keeps its digits.
    const glm::dvec3 origin = mesh.vertices[face[0]];
    glm::dvec3 normal(0);
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        normal += glm::cross(mesh.vertices[face[i]] - origin, mesh.vertices[face[i + 1]] - origin);
    return normal;
}

void mergeVertices(PolygonMesh& mesh, MeshRepairs& repairs) {
    std::vector<int> order(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int i) {
        const glm::dvec3& v = mesh.vertices[i];
        return std::tuple(v.x, v.y, v.z, i);
    };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });

    std::vector<int> first(mesh.vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && mesh.vertices[order[i]] == mesh.vertices[order[i - 1]];
        first[order[i]] = same ? first[order[i - 1]] : order[i];
        repairs.mergedVertices += same;
    }
    for (std::vector<int>& face : mesh.faces)
        for (int& vertex : face) vertex = first[vertex];
}

namespace {

// Whether the outline goes from a to b and straight back towards a.
bool turnsBack(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 in = b - a;
    const glm::dvec3 out = c - b;
    return glm::cross(in, out) == glm::dvec3(0) && glm::dot(in, out) < 0;
}

int dropFromOutline(const PolygonMesh& mesh, std::vector<int>& face) {
    const std::size_t before = face.size();
    for (bool changed = true; changed && face.size() >= 3;) {
        changed = false;
        for (std::size_t i = 0; i < face.size() && face.size() >= 3; ++i) {
            const int last = face[(i + face.size() - 1) % face.size()];
            const int next = face[(i + 1) % face.size()];
            const auto& v = mesh.vertices;
            if (face[i] != next && !turnsBack(v[last], v[face[i]], v[next])) continue;
            face.erase(face.begin() + static_cast<std::ptrdiff_t>(i--));
            changed = true;
        }
    }
    return static_cast<int>(before - face.size());
}

// Whether all corners lie on one line.
bool isOnALine(const PolygonMesh& mesh, const std::vector<int>& face) {
    const glm::dvec3 origin = mesh.vertices[face[0]];
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        if (glm::cross(mesh.vertices[face[i]] - origin, mesh.vertices[face[i + 1]] - origin) != glm::dvec3(0))
            return false;
    return true;
}

}  // namespace

void dropDegenerate(PolygonMesh& mesh, MeshRepairs& repairs) {
    const auto hasNoArea = [&](std::vector<int>& face) {
        const int dropped = dropFromOutline(mesh, face);
        if (face.size() < 3 || isOnALine(mesh, face)) return true;
        repairs.droppedVertices += dropped;
        return false;
    };
    repairs.droppedFaces += static_cast<int>(std::erase_if(mesh.faces, hasNoArea));
}

namespace {

// For each edge, from its lower to its higher vertex, the faces along it and whether they run that way.
struct EdgeUse {
    int face;
    bool forward;
};
using Edges = std::unordered_map<std::uint64_t, std::vector<EdgeUse>>;

std::uint64_t edgeKey(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

Edges findEdges(const PolygonMesh& mesh) {
    Edges edges;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const std::vector<int>& face = mesh.faces[f];
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int a = face[i], b = face[(i + 1) % face.size()];
            edges[edgeKey(a, b)].push_back({static_cast<int>(f), a < b});
        }
    }
    return edges;
}

// Six times the volume that the faces of a closed body enclose: positive when they face outwards.
double volume(const PolygonMesh& mesh, const std::vector<int>& faces, const std::vector<char>& turned) {
    const glm::dvec3 origin = mesh.vertices[mesh.faces[faces[0]][0]];
    double sum = 0;
    for (const int f : faces) {
        const double cone = glm::dot(faceNormal(mesh, mesh.faces[f]), mesh.vertices[mesh.faces[f][0]] - origin);
        sum += turned[f] ? -cone : cone;
    }
    return sum;
}

}  // namespace

void orientFaces(PolygonMesh& mesh, MeshRepairs& repairs) {
    const Edges edges = findEdges(mesh);
    const int count = static_cast<int>(mesh.faces.size());
    std::vector<char> seen(count, 0), turned(count, 0);
    for (int start = 0; start < count; ++start) {
        if (seen[start]) continue;
        // Walk over shared edges: two faces agree when they run along their edge in opposite ways.
        std::vector<int> body{start};
        bool closed = true;
        seen[start] = 1;
        for (std::size_t next = 0; next < body.size(); ++next) {
            const int f = body[next];
            const std::vector<int>& face = mesh.faces[f];
            for (std::size_t i = 0; i < face.size(); ++i) {
                const int a = face[i], b = face[(i + 1) % face.size()];
                const std::vector<EdgeUse>& uses = edges.at(edgeKey(a, b));
                if (uses.size() != 2) {
                    closed = false;
                    continue;
                }
                const EdgeUse& other = uses[0].face == f ? uses[1] : uses[0];
                if (seen[other.face]) continue;
                seen[other.face] = 1;
                const bool runsAlike = other.forward == (a < b);
                turned[other.face] = static_cast<char>(runsAlike != (turned[f] != 0));
                body.push_back(other.face);
            }
        }
        // A closed body faces outwards; of an open one the fewer faces are wrong.
        const auto turnedCount = std::count_if(body.begin(), body.end(), [&](int f) { return turned[f]; });
        const bool inverted =
            closed ? volume(mesh, body, turned) < 0 : 2 * turnedCount > static_cast<std::ptrdiff_t>(body.size());
        for (const int f : body) {
            if ((turned[f] != 0) == inverted) continue;
            std::reverse(mesh.faces[f].begin(), mesh.faces[f].end());
            ++repairs.turnedFaces;
        }
    }
}

}  // namespace gr
