#include "gr/mesh/mesh_repair.h"

#include "gr/mesh/parts.h"
#include "gr/mesh/places.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace gr {

void mergeVertices(FlatMesh& mesh, MeshRepairs& repairs) {
    PlaceTable<glm::dvec3> table;
    std::vector<int> first(mesh.vertices.size());
    for (int i = 0; i < static_cast<int>(first.size()); ++i) {
        first[i] = table.firstLike(mesh.vertices.data(), i);
        repairs.mergedVertices += first[i] != i;
    }
    for (int& vertex : mesh.corners) vertex = first[vertex];
}

namespace {

// Whether the outline goes from a to b and straight back towards a.
bool turnsBack(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 in = b - a;
    const glm::dvec3 out = c - b;
    return glm::cross(in, out) == glm::dvec3(0) && glm::dot(in, out) < 0;
}

// Whether corner i of a face repeats the next one or is the tip of a spike.
bool isDegenerate(const std::vector<glm::dvec3>& v, std::span<const int> face, std::size_t i) {
    const std::size_t last = i == 0 ? face.size() - 1 : i - 1, next = i + 1 == face.size() ? 0 : i + 1;
    return face[i] == face[next] || turnsBack(v[face[last]], v[face[i]], v[face[next]]);
}

// Whether all corners lie on one line.
bool isOnALine(const std::vector<glm::dvec3>& v, std::span<const int> face) {
    const glm::dvec3 origin = v[face[0]];
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        if (glm::cross(v[face[i]] - origin, v[face[i + 1]] - origin) != glm::dvec3(0)) return false;
    return true;
}

double sizeOf(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

// Whether a triangle has so much area that no rounding of cross products, at whichever corner, makes it none. Most do.
bool isClearlyATriangle(const std::vector<glm::dvec3>& v, std::span<const int> face) {
    if (face.size() != 3) return false;
    const glm::dvec3 a = v[face[1]] - v[face[0]], b = v[face[2]] - v[face[0]];
    const double size = sizeOf(a) + sizeOf(b);
    return sizeOf(glm::cross(a, b)) > 1e-10 * size * size;
}

bool needsRepair(const std::vector<glm::dvec3>& v, std::span<const int> face) {
    if (isClearlyATriangle(v, face)) return false;
    for (std::size_t i = 0; i < face.size(); ++i)
        if (isDegenerate(v, face, i)) return true;
    return isOnALine(v, face);
}

// One byte for each face; empty where none does.
std::vector<char> findRepairs(const FlatMesh& mesh) {
    std::vector<char> found(static_cast<std::size_t>(mesh.faceCount()));
    std::atomic<bool> any = false;
    inParts(mesh.faceCount(), [&](int first, int end) {
        bool anyHere = false;
        for (int f = first; f < end; ++f) {
            found[f] = needsRepair(mesh.vertices, mesh.face(f));
            anyHere |= found[f] != 0;
        }
        if (anyHere) any = true;
    });
    if (!any) found.clear();
    return found;
}

// Drops from the places in `corners` those that make an outline degenerate, and returns how many. outline: the
// vertices there.
int dropFromOutline(const std::vector<glm::dvec3>& v, std::vector<int>& outline, std::vector<int>& corners) {
    const std::size_t before = outline.size();
    for (bool changed = true; changed && outline.size() >= 3;) {
        changed = false;
        for (std::size_t i = 0; i < outline.size() && outline.size() >= 3; ++i) {
            if (!isDegenerate(v, outline, i)) continue;
            corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
            outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i--));
            changed = true;
        }
    }
    return static_cast<int>(before - outline.size());
}

}  // namespace

void dropDegenerate(FlatMesh& mesh, MeshRepairs& repairs) {
    const std::vector<char> needsRepair = findRepairs(mesh);
    if (needsRepair.empty()) return;
    // What is kept moves to the front.
    int size = 0, faces = 0;
    const auto keep = [&](int place) {
        mesh.forEachCornerList([&](auto& list) { list[size] = list[place]; });
        ++size;
    };
    std::vector<int> outline, places;
    for (int f = 0, begin = 0, end; f < mesh.faceCount(); ++f, begin = end) {
        end = mesh.end(f);
        if (needsRepair[f] != 0) {
            outline.assign(&mesh.corners[begin], &mesh.corners[0] + end);
            places.resize(outline.size());
            std::iota(places.begin(), places.end(), begin);
            const int dropped = dropFromOutline(mesh.vertices, outline, places);
            if (outline.size() < 3 || isOnALine(mesh.vertices, outline)) {
                ++repairs.droppedFaces;
                continue;
            }
            repairs.droppedVertices += dropped;
            for (const int place : places) keep(place);
        } else {
            for (int place = begin; place < end; ++place) keep(place);
        }
        if (!mesh.ends.empty()) mesh.ends[faces] = size;
        if (!mesh.groupOf.empty()) mesh.groupOf[faces] = mesh.groupOf[f];
        ++faces;
    }
    mesh.forEachCornerList([&](auto& list) { list.resize(size); });
    if (!mesh.ends.empty()) mesh.ends.resize(faces);
    if (!mesh.groupOf.empty()) mesh.groupOf.resize(faces);
}

}  // namespace gr
