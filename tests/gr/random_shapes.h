// Shapes, places and directions for tests that draw them at random.
#pragma once

#include "gr/database/database.h"
#include "support/test_random.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>

namespace gr {

// How many rays a test traces: more of them where GRSH_TEST_RAYS says so, 100 for a hundred times as many.
inline int rayCount(int usual) {
    const char* factor = std::getenv("GRSH_TEST_RAYS");
    return factor == nullptr ? usual : static_cast<int>(usual * std::atof(factor));
}

inline glm::dvec3 randomDirection(support::TestRandom& random) {
    const double z = 2 * random.next() - 1, phi = 2 * M_PI * random.next();
    const double radius = std::sqrt(1 - z * z);
    return {radius * std::cos(phi), radius * std::sin(phi), z};
}

inline glm::dvec3 randomPoint(support::TestRandom& random, double low, double high) {
    const double x = random.next(), y = random.next(), z = random.next();
    return glm::dvec3(low) + (high - low) * glm::dvec3(x, y, z);
}

// The cube [-1, 1]^3.
inline PolygonMesh cubeMesh() {
    PolygonMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.vertices.push_back({(i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1});
    mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return mesh;
}

// Triangles with all corners on the unit sphere: an icosahedron, each of its faces cut into four some times.
inline PolygonMesh icosphereMesh(int cuts) {
    const double g = (1 + std::sqrt(5.)) / 2;
    PolygonMesh mesh{{{-1, g, 0},
                      {1, g, 0},
                      {-1, -g, 0},
                      {1, -g, 0},
                      {0, -1, g},
                      {0, 1, g},
                      {0, -1, -g},
                      {0, 1, -g},
                      {g, 0, -1},
                      {g, 0, 1},
                      {-g, 0, -1},
                      {-g, 0, 1}},
                     {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (int cut = 0; cut < cuts; ++cut) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [entry, isNew] =
                middles.try_emplace(std::minmax({a, b}), static_cast<int>(mesh.vertices.size()));
            if (isNew) mesh.vertices.push_back(mesh.vertices[a] + mesh.vertices[b]);
            return entry->second;
        };
        std::vector<std::vector<int>> faces;
        for (const std::vector<int>& f : mesh.faces) {
            const int a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
            for (const std::array<int, 3>& t : {std::array{f[0], a, c}, {f[1], b, a}, {f[2], c, b}, {a, b, c}})
                faces.emplace_back(t.begin(), t.end());
        }
        mesh.faces = std::move(faces);
    }
    for (glm::dvec3& v : mesh.vertices) v = glm::normalize(v);
    return mesh;
}

inline PolyhedronNode polyhedronNode(const PolygonMesh& mesh) {
    MeshRepairs repairs;
    return {Polyhedron::make(mesh, repairs)};
}

// Turns and stretches a node twice over, which shears it. Along no axis it becomes larger than size, nor smaller than
// size * exp(-2 * squeeze).
inline void squeezeAtRandom(Database& database, const std::string& node, double size, double squeeze,
                            support::TestRandom& random) {
    for (int i = 0; i < 2; ++i) {
        for (int axis = 0; axis < 3; ++axis) database.rotate(node, axis, 360 * random.next());
        const glm::dvec3 factors = glm::exp(-squeeze * randomPoint(random, 0, 1));
        database.scale(node, glm::dvec3(0), i == 0 ? size * factors : factors);
    }
}

inline glm::dvec3 transformed(const glm::dmat4& matrix, const glm::dvec3& point) {
    return matrix * glm::dvec4(point, 1);
}

}  // namespace gr
