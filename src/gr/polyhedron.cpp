#include "gr/polyhedron.h"

#include "core/error.h"

#include "gr/mesh_repair.h"
#include "gr/shape.h"
#include "gr/triangle_pack.h"

#include <algorithm>
#include <optional>

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

// Most packs are missed by most rays: how far along the ray is asked only where it is not.
template<class Pack>
[[gnu::always_inline]] inline std::optional<TriangleHit<PackLanes>> intersectPack(const PackRay& ray,
                                                                                  const Pack& pack) {
    static_assert(PackLanes::size == 4, "a pack is as wide as the baseline's lanes");
    const auto corner = [&](int i) {
        const auto axis = [&](int k) { return PackLanes::load_aligned(pack.vertex[i][k]); };
        return core::Vec3<PackLanes>(axis(ray.axes.x), axis(ray.axes.y), axis(ray.axes.z));
    };
    const core::Vec3<PackLanes> a = corner(0), b = corner(1), c = corner(2);
    const TriangleCrossing<PackLanes> crossing = ray.cross(a, b, c);
    if (!xsimd::any(crossing.inside)) return std::nullopt;
    const TriangleHit<PackLanes> hit = ray.hit(crossing, a, b, c);
    if (!xsimd::any(hit.t < ray.tMax)) return std::nullopt;
    return hit;
}

}  // namespace

bool Polyhedron::intersect(PackRay& ray, Hit& hit) const {
    bool found = false;
    for (std::size_t i = 0; i < packs_.size(); ++i) {
        const auto packHit = intersectPack(ray, packs_[i]);
        if (!packHit) continue;
        alignas(16) float t[width], b1[width], b2[width];
        packHit->t.store_aligned(t);
        packHit->b1.store_aligned(b1);
        packHit->b2.store_aligned(b2);
        const int nearest = static_cast<int>(std::min_element(t, t + width) - t);
        hit = {t[nearest], 0, static_cast<std::uint32_t>(i * width + static_cast<std::size_t>(nearest)), b1[nearest],
               b2[nearest]};
        ray.shortenTo(hit.t);
        found = true;
    }
    return found;
}

bool Polyhedron::occluded(const PackRay& ray) const {
    for (const Pack& pack : packs_)
        if (intersectPack(ray, pack)) return true;
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
