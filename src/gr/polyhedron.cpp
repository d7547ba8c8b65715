#include "gr/polyhedron.h"

#include "core/error.h"

#include "gr/mesh_repair.h"
#include "gr/shape.h"
#include "gr/triangle.h"

namespace gr {
namespace {

// As many lanes as a pack has, whatever else the machine could do: SSE2 is part of every x86-64.
using PackLanes = xsimd::batch<float>;

}  // namespace

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
    : packs_((triangles.size() + width - 1) / width), triangleCount_(triangles.size()) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const core::Vec3f v(vertices[triangles[i][corner]]);
            extent_ = std::max(extent_, core::largestComponent(v));
            for (int axis = 0; axis < 3; ++axis) packs_[i / width].vertex[corner][axis][i % width] = v[axis];
        }
    }
}

core::Vec3f Polyhedron::vertex(std::uint32_t triangle, int corner) const {
    const auto& axes = packs_[triangle / width].vertex[corner];
    const int lane = triangle % width;
    return {axes[0][lane], axes[1][lane], axes[2][lane]};
}

namespace {

core::Ray<PackLanes> broadcast(const core::Rayf& ray) {
    return {core::broadcast<PackLanes>(ray.origin), core::broadcast<PackLanes>(ray.direction), PackLanes(ray.tMax)};
}

template<class Pack>
TriangleHit<PackLanes> intersectPack(const TriangleRay<PackLanes>& ray, const Pack& pack) {
    static_assert(PackLanes::size == 4, "a pack is as wide as the baseline's lanes");
    const auto corner = [&](int i) {
        const auto& axes = pack.vertex[i];
        return core::Vec3<PackLanes>(PackLanes::load_aligned(axes[0]), PackLanes::load_aligned(axes[1]),
                                     PackLanes::load_aligned(axes[2]));
    };
    return ray.intersect(corner(0), corner(1), corner(2));
}

}  // namespace

bool Polyhedron::intersect(const core::Rayf& ray, Hit& hit) const {
    TriangleRay<PackLanes> lanesRay(broadcast(ray));
    float nearest = ray.tMax;
    for (std::size_t i = 0; i < packs_.size(); ++i) {
        const TriangleHit<PackLanes> found = intersectPack(lanesRay, packs_[i]);
        if (!xsimd::any(found.t < PackLanes(nearest))) continue;
        alignas(16) float t[width], b1[width], b2[width];
        found.t.store_aligned(t);
        found.b1.store_aligned(b1);
        found.b2.store_aligned(b2);
        for (int lane = 0; lane < width; ++lane) {
            if (t[lane] >= nearest) continue;
            nearest = t[lane];
            hit.t = nearest;
            hit.triangle = static_cast<std::uint32_t>(i * width + lane);
            hit.b1 = b1[lane];
            hit.b2 = b2[lane];
        }
        lanesRay.tMax = PackLanes(nearest);
    }
    return nearest < ray.tMax;
}

bool Polyhedron::occluded(const core::Rayf& ray) const {
    const TriangleRay<PackLanes> lanesRay(broadcast(ray));
    for (const Pack& pack : packs_)
        if (xsimd::any(intersectPack(lanesRay, pack).t < PackLanes(ray.tMax))) return true;
    return false;
}

ShapePoint Polyhedron::surfaceAt(const Hit& hit) const {
    const core::Vec3f a = vertex(hit.triangle, 0);
    const core::Vec3f b = vertex(hit.triangle, 1);
    const core::Vec3f c = vertex(hit.triangle, 2);
    // Rounding may put a hit beyond an edge; a little inside, a ray that goes on does not start outside the mesh.
    constexpr float margin = 16 * 0x1p-23f;
    const float b1 = std::max(hit.b1, margin);
    const float b2 = std::max(hit.b2, margin);
    const float b0 = std::max(1 - hit.b1 - hit.b2, margin);
    const core::Vec3f position = (a * b0 + b * b1 + c * b2) / (b0 + b1 + b2);
    return {position, glm::cross(b - a, c - a)};
}

}  // namespace gr
