#include "gr/polyhedron.h"

#include "core/error.h"
#include "gr/mesh_repair.h"
#include "gr/pack.h"

#include <algorithm>

namespace gr {

std::string MeshRepairs::text() const {
    std::string text;
    const auto add = [&](int count, const char* one, const char* many) {
        if (count == 0) return;
        if (!text.empty()) text += ", ";
        text += std::to_string(count) + " " + (count == 1 ? one : many);
    };
    add(mergedVertices, "duplicate vertex merged", "duplicate vertices merged");
    add(droppedVertices, "degenerate vertex dropped", "degenerate vertices dropped");
    add(droppedFaces, "face without area dropped", "faces without area dropped");
    add(turnedFaces, "wrong-way face turned", "wrong-way faces turned");
    return text;
}

std::shared_ptr<const Polyhedron> Polyhedron::make(PolygonMesh mesh, MeshRepairs& repairs) {
    mergeVertices(mesh, repairs);
    dropDegenerate(mesh, repairs);
    if (mesh.faces.empty()) throw core::Error("MESH", "EMPTY", "", "no face has an area");
    orientFaces(mesh, repairs);
    const std::vector<glm::ivec3> triangles = triangulate(mesh);
    return std::shared_ptr<const Polyhedron>(new Polyhedron(mesh.vertices, triangles));
}

Polyhedron::Polyhedron(const std::vector<glm::dvec3>& vertices, const std::vector<glm::ivec3>& triangles)
    : packs_((triangles.size() + packWidth - 1) / packWidth), triangleCount_(triangles.size()) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto corner = [&](int k) { return core::Vec3f(vertices[static_cast<std::size_t>(triangles[i][k])]); };
        const std::array<core::Vec3f, 3> corners{corner(0), corner(1), corner(2)};
        for (const core::Vec3f& v : corners) extent_ = std::max(extent_, core::largestComponent(v));
        packs_[i / packWidth].set(static_cast<int>(i % packWidth), corners);
    }
}

Polyhedron::~Polyhedron() = default;

core::Vec3f Polyhedron::vertex(std::uint32_t triangle, int corner) const {
    return packs_[triangle / packWidth].corner(static_cast<int>(triangle % packWidth), corner);
}

std::size_t Polyhedron::bytes() const {
    return packs_.size() * sizeof(TrianglePack);
}

void Polyhedron::intersect(const PackRay& ray, std::uint32_t instance, Hit& nearest) const {
    for (std::size_t i = 0; i < packs_.size(); ++i) {
        packs_[i].intersect(ray, [&](const TriangleHit<PackLanes>& found) {
            const LaneValues t(found.t), b1(found.b1), b2(found.b2);
            for (int lane = 0; lane < packWidth; ++lane) {
                const auto triangle = static_cast<std::uint32_t>(i * packWidth) + static_cast<std::uint32_t>(lane);
                const Hit hit{t[lane], instance, triangle, b1[lane], b2[lane]};
                if (hit.isBefore(nearest)) nearest = hit;
            }
        });
    }
}

bool Polyhedron::occluded(const PackRay& ray) const {
    bool isMet = false;
    for (std::size_t i = 0; i < packs_.size() && !isMet; ++i)
        packs_[i].intersect(
            ray, [&](const TriangleHit<PackLanes>& found) { isMet = xsimd::any(found.t < PackLanes(core::infinity)); });
    return isMet;
}

namespace {

float lengthSquared(const core::Vec3f& v) {
    return glm::dot(v, v);
}

}  // namespace

ShapePoint Polyhedron::surfaceAt(const core::Rayf& ray, const Hit& hit, const core::Vec3f& margin) const {
    const core::Vec3f a = vertex(hit.triangle, 0);
    const core::Vec3f b = vertex(hit.triangle, 1);
    const core::Vec3f c = vertex(hit.triangle, 2);
    // In double precision: in single, a thin triangle's would be turned along it by more than the offset allows for.
    const core::Vec3f normal(glm::cross(glm::dvec3(b - a), glm::dvec3(c - a)));
    // A vertex's weight is the distance from the edge opposite over the height above it; the smallest height stands on
    // the longest edge. To be clear of the face beyond an edge takes 1 / sin(angle) times the margin where they meet at
    // an acute angle: 4 is enough for 15 degrees.
    const float longest = std::max({lengthSquared(b - a), lengthSquared(c - b), lengthSquared(a - c)});
    const float least = core::min(4 * std::sqrt(lengthSquared(margin) * longest / lengthSquared(normal)), 0.25f);
    const float b0 = std::max(1 - hit.b1 - hit.b2, least);
    const float b1 = std::max(hit.b1, least);
    const float b2 = std::max(hit.b2, least);
    const core::Vec3f position = (a * b0 + b * b1 + c * b2) / (b0 + b1 + b2);
    return {position, normal, glm::dot(ray.direction, normal) < 0};
}

}  // namespace gr
