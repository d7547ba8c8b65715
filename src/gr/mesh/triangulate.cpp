#include "core/error.h"
#include "gr/mesh/mesh_repair.h"
#include "gr/mesh/outline.h"

#include <algorithm>
#include <array>

namespace gr {
namespace {

using Vertices = std::vector<glm::dvec3>;

// A face as a picture shows it whose axes are x and y.
Outline project(const Vertices& vertices, std::span<const int> face, const glm::dvec3& x, const glm::dvec3& y) {
    Outline outline;
    outline.reserve(face.size());
    for (const int v : face) {
        const glm::dvec3 place = vertices[v] - vertices[face[0]];
        outline.emplace_back(glm::dot(place, x), glm::dot(place, y));
    }
    return outline;
}

// Along an axis, from the side from which the face runs counter-clockwise.
Outline projectAlongAxis(const Vertices& vertices, std::span<const int> face, const glm::dvec3& normal, int axis) {
    glm::dvec3 x(0), y(0);
    x[(axis + 1) % 3] = 1;
    y[(axis + 2) % 3] = 1;
    return normal[axis] > 0 ? project(vertices, face, x, y) : project(vertices, face, y, x);
}

// Along the normal itself.
Outline projectAlong(const Vertices& vertices, std::span<const int> face, const glm::dvec3& normal) {
    const glm::dvec3 n = glm::normalize(normal), size = glm::abs(n);
    glm::dvec3 least(0);
    least[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
    const glm::dvec3 x = glm::normalize(glm::cross(least, n));
    return project(vertices, face, x, glm::cross(n, x));
}

// Corners that are in a line as they are seen need not be in a line: then there is a part of the face between them that
// is seen edge-on.
void addUpright(const Vertices& vertices, std::span<const int> face, const std::vector<int>& onLine,
                std::vector<glm::ivec3>& triangles) {
    for (std::size_t i = 1; i + 1 < onLine.size(); ++i) {
        const glm::dvec3 first = vertices[face[onLine[0]]];
        const glm::dvec3 a = vertices[face[onLine[i]]] - first, b = vertices[face[onLine[i + 1]]] - first;
        if (glm::length(glm::cross(a, b)) > 1e-6 * glm::length(a) * glm::length(b))
            triangles.emplace_back(onLine[0], onLine[i], onLine[i + 1]);
    }
}

// The triangles of one face as numbers of its corners. False when its outline is not simple from wherever it is seen.
// From the side of the normal's largest axis first: coordinates are as they were given from there, and corners in a
// line are exactly in a line. The outline of a face that is not flat may cross itself from there and not along the
// normal, or not along another axis.
bool cutPolygon(const Vertices& vertices, std::span<const int> face, std::vector<glm::ivec3>& triangles) {
    // An outline whose areas cancel, a bow tie, has no side to be looked at from.
    const glm::dvec3 normal = faceNormal(vertices, face), size = glm::abs(normal);
    if (normal == glm::dvec3(0)) return false;
    const auto cuts = [&](const Outline& outline) {
        triangles.clear();
        std::vector<int> onLine;
        if (crossesItself(outline) || !clipEars(outline, triangles, onLine)) return false;
        addUpright(vertices, face, onLine, triangles);
        return true;
    };
    std::array axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](int i, int j) { return size[i] > size[j]; });
    // Along an axis that runs nearly in the face nothing is seen but roundings.
    const auto cutsAlong = [&](int axis) {
        return size[axis] > 0.01 * size[axes[0]] && cuts(projectAlongAxis(vertices, face, normal, axis));
    };
    return cutsAlong(axes[0]) || cuts(projectAlong(vertices, face, normal)) || cutsAlong(axes[1]) || cutsAlong(axes[2]);
}

// The ways to cut a quadrilateral: along the diagonal from corner 1 to corner 3, or from corner 0 to corner 2.
constexpr std::array<std::array<glm::ivec3, 2>, 2> quadCuts{
    {{glm::ivec3(3, 0, 1), glm::ivec3(3, 1, 2)}, {glm::ivec3(0, 1, 2), glm::ivec3(0, 2, 3)}}};

// Whether its corners lie in a plane but for the roundings of a file: the smallest of the heights at which one lies
// over the triangle of the others is next to nothing beside its longest side or diagonal.
bool isFlatQuad(const std::array<glm::dvec3, 4>& v) {
    const double sixDigits = 1e-6;
    double area = 0, length = 0;
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 a = v[i], b = v[(i + 1) % 4] - a, c = v[(i + 2) % 4] - a;
        area = std::max(area, glm::length(glm::cross(b, c)));
        length = std::max({length, glm::length(b), glm::length(c)});
    }
    return std::abs(glm::dot(glm::cross(v[1] - v[0], v[2] - v[0]), v[3] - v[0])) <= sixDigits * length * area;
}

// A diagonal is right if both triangles look to the side of the whole. One that is not flat may have none: seen along
// its normal it crosses itself, but it is a surface of two triangles nevertheless, and the shorter diagonal is taken.
bool cutQuad(const Vertices& vertices, std::span<const int> face, std::vector<glm::ivec3>& triangles) {
    const std::array<glm::dvec3, 4> v{vertices[face[0]], vertices[face[1]], vertices[face[2]], vertices[face[3]]};
    const glm::dvec3 normal = faceNormal(vertices, face);
    const auto looksAlong = [&](const glm::ivec3& t) {
        return glm::dot(glm::cross(v[t.y] - v[t.x], v[t.z] - v[t.x]), normal) > 0;
    };
    const auto cut = [&](const std::array<glm::ivec3, 2>& way) { triangles.assign(way.begin(), way.end()); };
    for (const auto& way : quadCuts) {
        if (!looksAlong(way[0]) || !looksAlong(way[1])) continue;
        cut(way);
        return true;
    }
    if (isFlatQuad(v)) return false;
    cut(quadCuts[glm::distance(v[1], v[3]) <= glm::distance(v[0], v[2]) ? 0 : 1]);
    return true;
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
        const std::span<const int> face = mesh.face(f);
        if (face.size() == 4 ? cutQuad(mesh.vertices, face, ofFace) : cutPolygon(mesh.vertices, face, ofFace)) {
            for (const glm::ivec3& triangle : ofFace) triangles.push_back(triangle + begin);
        } else {
            if (crossing == Crossing::isAnError) throwCrossing(face);
            ++repairs.crossingFaces;
        }
    }
    return triangles;
}

}  // namespace gr
