#include "gr/mesh/polyhedron.h"

#include "core/error.h"
#include "gr/mesh/mesh_repair.h"
#include "gr/mesh/mesh_smooth.h"
#include "gr/mesh/pack.h"
#include "gr/mesh/parts.h"
#include "gr/mesh/triangle_order.h"
#include "gr/near_origin.h"

#include <algorithm>
#include <atomic>

namespace gr {

// Vertices at one place are no fault: most programs write one for each side of an edge, or for each triangle.
std::string MeshRepairs::text() const {
    std::string text;
    const auto add = [&](int count, const char* one, const char* many) {
        if (count == 0) return;
        if (!text.empty()) text += ", ";
        text += std::to_string(count) + " " + (count == 1 ? one : many);
    };
    add(droppedVertices, "degenerate vertex dropped", "degenerate vertices dropped");
    add(droppedFaces, "face without area dropped", "faces without area dropped");
    add(turnedFaces, "wrong-way face turned", "wrong-way faces turned");
    add(crossingFaces, "self-crossing face dropped", "self-crossing faces dropped");
    add(linesAndPoints, "line or point left out", "lines and points left out");
    add(absentReferences, "corner names a normal or u v that is not there",
        "corners name normals or u v that are not there");
    return text;
}

namespace {

// Its square may be beyond what a number can be.
glm::dvec3 unit(const glm::dvec3& v) {
    return glm::normalize(v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

// What faces' corners have of what their vertices have.
template<class Value>
void spread(const std::vector<Value>& ofVertices, const std::vector<int>& corners, std::vector<Value>& ofCorners) {
    if (ofVertices.empty()) return;
    ofCorners.reserve(corners.size());
    for (const int vertex : corners) ofCorners.push_back(ofVertices[vertex]);
}

}  // namespace

FlatMesh::FlatMesh(const PolygonMesh& mesh) : vertices(mesh.vertices) {
    for (const std::vector<int>& face : mesh.faces) {
        corners.insert(corners.end(), face.begin(), face.end());
        ends.push_back(static_cast<int>(corners.size()));
    }
    std::vector<PackedNormal> packed;
    packed.reserve(mesh.normals.size());
    for (const glm::dvec3& normal : mesh.normals) packed.push_back(packNormal(core::Vec3f(unit(normal))));
    spread(packed, corners, normals);
    spread(mesh.uvs, corners, uvs);
    spread(mesh.colours, corners, colours);
}

namespace {

// Mends all but vertices at one place, smooths, and cuts the faces.
std::vector<glm::ivec3> makeTriangles(FlatMesh& mesh, Crossing crossing, double smoothDegrees, MeshRepairs& repairs) {
    dropDegenerate(mesh, repairs);
    if (mesh.faceCount() > 0) orientFaces(mesh, repairs);
    smoothNormals(mesh, smoothDegrees);
    std::vector<glm::ivec3> triangles = triangulate(mesh, crossing, repairs);
    if (triangles.empty()) throw core::Error("MESH", "EMPTY", "", "no face has an area");
    return triangles;
}

glm::dvec3 originFor(const FlatMesh& mesh) {
    glm::dvec3 low(core::infinity), high(-core::infinity);
    for (const glm::dvec3& vertex : mesh.vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    return nearOrigin(low, high);
}

TrianglePack makePack(const FlatMesh& mesh, const glm::dvec3& origin, std::span<const glm::ivec3> triangles) {
    TrianglePack pack{};
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto corner = [&](int k) { return core::Vec3f(mesh.vertices[mesh.corners[triangles[i][k]]] - origin); };
        pack.set(static_cast<int>(i), {corner(0), corner(1), corner(2)});
    }
    return pack;
}

}  // namespace

std::shared_ptr<const Polyhedron> Polyhedron::make(const PolygonMesh& given, MeshRepairs& repairs,
                                                   double smoothDegrees) {
    FlatMesh mesh(given);
    mergeVertices(mesh, repairs);
    return std::shared_ptr<const Polyhedron>(
        new Polyhedron(mesh, makeTriangles(mesh, Crossing::isAnError, smoothDegrees, repairs)));
}

std::shared_ptr<const Polyhedron> Polyhedron::make(FlatMesh mesh, MeshRepairs& repairs, double smoothDegrees) {
    return std::shared_ptr<const Polyhedron>(
        new Polyhedron(mesh, makeTriangles(mesh, Crossing::isDropped, smoothDegrees, repairs)));
}

Polyhedron::Polyhedron(const FlatMesh& mesh, std::vector<glm::ivec3> triangles)
    : packs_(std::make_unique_for_overwrite<TrianglePack[]>((triangles.size() + packWidth - 1) / packWidth)),
      triangleCount_(triangles.size()),
      origin_(originFor(mesh)) {
    sortIntoPacks(mesh, triangles);
    const std::vector<core::Bounds> bounds =
        ofParts<core::Bounds>(static_cast<int>(packCount()), [&](int first, int end) {
            core::Bounds box;
            for (int i = first; i < end; ++i) {
                const std::size_t at = static_cast<std::size_t>(i) * packWidth;
                const std::size_t count = std::min<std::size_t>(packWidth, triangleCount_ - at);
                packs_[i] = makePack(mesh, origin_, std::span(triangles).subspan(at, count));
                box.include(packBounds(static_cast<std::uint32_t>(i)));
            }
            return box;
        });
    for (const core::Bounds& box : bounds) bounds_.include(box);
    if (!mesh.normals.empty()) setNormals(mesh, triangles);
    keepWhatIsKnown(mesh, triangles);
}

namespace {

// The normals of a triangle's corners, outwards; and whether they are no more than its face's.
struct CornerNormals {
    std::array<core::Vec3f, 3> of;
    bool areFlat;

    // rounding: by how much a file's digits may have moved a vertex.
    CornerNormals(const FlatMesh& mesh, const glm::ivec3& triangle, double rounding) {
        const auto corner = [&](int k) { return mesh.vertices[mesh.corners[triangle[k]]]; };
        const glm::dvec3 a = corner(1) - corner(0), b = corner(2) - corner(0), area = glm::cross(a, b);
        const core::Vec3f flat(glm::normalize(area));
        float outwards = 0;
        for (int k = 0; k < 3; ++k) {
            const PackedNormal packed = mesh.normals[triangle[k]];
            of[k] = packed == noNormal ? core::Vec3f(0) : unpackNormal(packed);
            outwards += glm::dot(of[k], flat);
        }
        for (core::Vec3f& normal : of) normal = normal == core::Vec3f(0) ? flat : outwards < 0 ? -normal : normal;

        // Rounding turns a triangle about its longest edge, the more the thinner it is.
        const double longest = std::max({glm::length(a), glm::length(b), glm::length(b - a)});
        const double turned = 2 * rounding * longest / glm::length(area);
        areFlat = areWithin(tenthOfADegree, flat) ||
                  (areWithin(tenthOfADegree, of[0]) && areWithin(fiveDegrees + static_cast<float>(turned), flat));
    }

private:
    static constexpr float tenthOfADegree = 1.75e-3f, fiveDegrees = 8.7e-2f;

    bool areWithin(float angle, const core::Vec3f& direction) const {
        return std::all_of(of.begin(), of.end(),
                           [&](const core::Vec3f& normal) { return glm::distance(normal, direction) <= angle; });
    }
};

}  // namespace

void Polyhedron::setNormals(const FlatMesh& mesh, const std::vector<glm::ivec3>& triangles) {
    constexpr double sixDigits = 1e-6;
    const double rounding = sixDigits * (core::largestComponent(core::Vec3f(origin_)) + bounds_.reach());
    normals_.resize(3 * triangles.size());
    std::atomic<bool> anyIsSmooth = false;
    inParts(static_cast<int>(triangles.size()), [&](int first, int end) {
        bool isSmooth = false;
        for (int i = first; i < end; ++i) {
            const CornerNormals normals(mesh, triangles[i], rounding);
            isSmooth |= !normals.areFlat;
            for (int k = 0; k < 3; ++k)
                normals_[3 * static_cast<std::size_t>(i) + static_cast<std::size_t>(k)] = packNormal(normals.of[k]);
        }
        if (isSmooth) anyIsSmooth = true;
    });
    // Normals that only say again how each face lies are not worth their bytes.
    if (!anyIsSmooth) normals_ = {};
}

namespace {

// The values of triangles' corners; none where the mesh has none.
template<class Value>
std::vector<Value> ofCorners(const std::vector<Value>& values, const std::vector<glm::ivec3>& triangles) {
    std::vector<Value> kept;
    if (values.empty()) return kept;
    kept.reserve(3 * triangles.size());
    for (const glm::ivec3& triangle : triangles)
        for (int k = 0; k < 3; ++k) kept.push_back(values[static_cast<std::size_t>(triangle[k])]);
    return kept;
}

}  // namespace

void Polyhedron::keepWhatIsKnown(const FlatMesh& mesh, const std::vector<glm::ivec3>& triangles) {
    uvs_ = ofCorners(mesh.uvs, triangles);
    colours_ = ofCorners(mesh.colours, triangles);
    if (mesh.groups.empty()) return;
    groups_ = mesh.groups;
    groupOf_.reserve(triangles.size());
    for (const glm::ivec3& triangle : triangles) groupOf_.push_back(mesh.groupOf[mesh.faceOf(triangle[0])]);
}

Polyhedron::~Polyhedron() = default;

core::Vec3f Polyhedron::vertex(std::uint32_t triangle, int corner) const {
    return packs_[triangle / packWidth].corner(static_cast<int>(triangle % packWidth), corner);
}

std::vector<FlatSide> Polyhedron::flatSides() const {
    std::vector<FlatSide> sides;
    for (std::uint32_t i = 0; i < triangleCount_; ++i) {
        const glm::dvec3 corner(vertex(i, 0));
        sides.push_back({corner, glm::dvec3(vertex(i, 1)) - corner, glm::dvec3(vertex(i, 2)) - corner, true});
    }
    return sides;
}

std::size_t Polyhedron::bytes() const {
    return packCount() * sizeof(TrianglePack) + normals_.size() * sizeof(PackedNormal) +
           uvs_.size() * sizeof(core::Vec2f) + colours_.size() * sizeof(core::Rgbf) +
           groupOf_.size() * sizeof(std::uint32_t);
}

std::size_t Polyhedron::packCount() const {
    return (triangleCount_ + packWidth - 1) / packWidth;
}

core::Bounds Polyhedron::packBounds(std::uint32_t pack) const {
    core::Bounds bounds;
    const std::size_t end = std::min<std::size_t>((pack + 1) * packWidth, triangleCount_);
    for (std::size_t triangle = pack * packWidth; triangle < end; ++triangle)
        for (int corner = 0; corner < 3; ++corner) bounds.include(vertex(static_cast<std::uint32_t>(triangle), corner));
    return bounds;
}

void Polyhedron::intersect(const PackRay& ray, std::uint32_t pack, std::uint32_t instance, Hit& nearest) const {
    packs_[pack].intersect(ray, [&](const TriangleHit<PackLanes>& found) {
        if (!xsimd::any(found.t <= PackLanes(nearest.t))) return;
        const LaneValues t(found.t), b1(found.b1), b2(found.b2);
        for (int lane = 0; lane < packWidth; ++lane) {
            const Hit hit{t[lane], instance, pack * packWidth + static_cast<std::uint32_t>(lane), b1[lane], b2[lane]};
            if (hit.isBefore(nearest)) nearest = hit;
        }
    });
}

void Polyhedron::intersect(const PackRay& ray, std::uint32_t instance, Hit& nearest) const {
    for (std::uint32_t pack = 0; pack < packCount(); ++pack) intersect(ray, pack, instance, nearest);
}

bool Polyhedron::occluded(const PackRay& ray, std::uint32_t pack) const {
    bool isMet = false;
    packs_[pack].intersect(
        ray, [&](const TriangleHit<PackLanes>& found) { isMet = xsimd::any(found.t < PackLanes(core::infinity)); });
    return isMet;
}

bool Polyhedron::occluded(const PackRay& ray) const {
    for (std::uint32_t pack = 0; pack < packCount(); ++pack)
        if (occluded(ray, pack)) return true;
    return false;
}

}  // namespace gr
