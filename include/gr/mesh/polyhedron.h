// A polygon mesh, cut into triangles that know nothing of materials or places.
#pragma once

#include "core/bounds.h"
#include "gr/hit.h"
#include "gr/mesh/octahedral.h"
#include "gr/mesh/triangle.h"
#include "gr/shapes/flat_side.h"
#include "gr/shapes/surface.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gr {

struct PackRay;
struct TrianglePack;

// Vertices and faces as a script gives them; a face lists its vertices, from 0, in the order of its outline.
struct PolygonMesh {
    std::vector<glm::dvec3> vertices;
    std::vector<std::vector<int>> faces;
    // Of each vertex, or empty:
    std::vector<glm::dvec3> normals{};  // for shading, of any length but 0
    std::vector<core::Vec2f> uvs{};  // v upwards
    std::vector<core::Rgbf> colours{};  // linear
};

// Faces that a file has under one name, and what they are made of there; "" where it gives none.
struct MeshGroup {
    std::string name, material;

    bool operator==(const MeshGroup&) const = default;
};

// The same in few arrays, as a million faces are kept.
struct FlatMesh {
    std::vector<glm::dvec3> vertices;
    std::vector<int> corners;  // the vertices of all faces, one face after another
    std::vector<int> ends;  // of each face in `corners`; empty: all faces are triangles
    // Of each corner, or empty:
    std::vector<PackedNormal> normals;  // for shading
    std::vector<core::Vec2f> uvs;  // v upwards
    std::vector<core::Rgbf> colours;  // linear
    std::vector<MeshGroup> groups;
    std::vector<std::uint32_t> groupOf;  // of each face in `groups`; empty where there are none

    FlatMesh() = default;
    explicit FlatMesh(const PolygonMesh& mesh);

    int faceCount() const { return static_cast<int>(ends.empty() ? corners.size() / 3 : ends.size()); }
    int begin(int face) const { return ends.empty() ? 3 * face : face == 0 ? 0 : ends[face - 1]; }
    int end(int face) const { return ends.empty() ? 3 * face + 3 : ends[face]; }
    std::span<const int> face(int face) const { return {&corners[begin(face)], &corners[0] + end(face)}; }

    // The face that a place in `corners` belongs to.
    std::size_t faceOf(int corner) const {
        if (ends.empty()) return static_cast<std::size_t>(corner) / 3;
        return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), corner) - ends.begin());
    }

    // Calls function(list) for each list that has a value for each corner.
    template<class Function>
    void forEachCornerList(Function&& function) {
        function(corners);
        if (!normals.empty()) function(normals);
        if (!uvs.empty()) function(uvs);
        if (!colours.empty()) function(colours);
    }
};

// What was mended while a polyhedron was made.
struct MeshRepairs {
    int mergedVertices = 0;  // at the very place of an earlier one
    int droppedVertices = 0;  // repeated within a face, or there and straight back again
    int droppedFaces = 0;  // without area
    int turnedFaces = 0;  // wound against their neighbours
    int crossingFaces = 0;  // dropped because their outline crosses itself
    int linesAndPoints = 0;  // left out
    int absentReferences = 0;  // corners that name a normal or u v which is not there

    std::string text() const;  // empty when no fault was mended
};

class Polyhedron {
public:
    static constexpr bool isEndless = false, isAxisFaced = false;

    ~Polyhedron();
    // Throws core::Error for a face that is not simple (its outline crosses itself) and for a mesh without any area.
    // mesh: indices within range, finite coordinates, at least three indices to a face. One without normals gets some,
    // where its faces' differ by less than smoothDegrees (smoothNormals).
    static std::shared_ptr<const Polyhedron> make(const PolygonMesh& mesh, MeshRepairs& repairs,
                                                  double smoothDegrees = 0);
    // The same for a mesh from elsewhere: no two of its vertices are at one place, and a face that is not simple is
    // dropped.
    static std::shared_ptr<const Polyhedron> make(FlatMesh mesh, MeshRepairs& repairs, double smoothDegrees = 0);

    // Replaces `nearest` by the hit of a triangle that comes before it. instance: what stands here for the polyhedron.
    void intersect(const PackRay& ray, std::uint32_t instance, Hit& nearest) const;
    bool occluded(const PackRay& ray) const;
    // The same for one of the packs that the triangles lie in, near ones together.
    void intersect(const PackRay& ray, std::uint32_t pack, std::uint32_t instance, Hit& nearest) const;
    bool occluded(const PackRay& ray, std::uint32_t pack) const;
    std::size_t packCount() const;
    core::Bounds packBounds(std::uint32_t pack) const;
    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const HitOf<Real>& hit,
                               const core::Vec3<Real>& margin) const;  // polyhedron_surface.h

    // Those of its flat faces, in the space of the vertices it was given; u and v are the vertices', if they have any.
    template<class Real>
    Coordinates<Real> coordinatesAt(const ShapePoint<Real>& point, const HitOf<Real>& hit) const {
        Coordinates<Real> found = flatCoordinatesAt(point);
        if (!uvs_.empty()) found.uv = uvAt(hit);
        return found;
    }
    template<class Real>
    Coordinates<Real> flatCoordinatesAt(const ShapePoint<Real>& point) const {
        return flatCoordinates<Real>(point.position + core::broadcast<Real>(core::Vec3f(origin_)), point.normal);
    }

    // Whether it has normals of its own for shading,
    bool hasNormals() const { return !normals_.empty(); }
    // and the one at a hit, outwards, not of unit length; it may be 0.
    template<class Real>
    core::Vec3<Real> shadingNormal(const HitOf<Real>& hit) const;  // likewise
    // From a point of a face to the round shape that the normals stand for: the mean, weighted as the normals are, of
    // the ways to the planes across them at the corners (Hanika, "Hacking the Shadow Terminator", in Ray Tracing Gems
    // II, 2021), of those planes only that lie on the ray's side. So where the mesh is hollow there is no way to go.
    template<class Real>
    core::Vec3<Real> lift(const HitOf<Real>& hit, const ShapePoint<Real>& point) const;  // likewise

    // What its file tells of a triangle's corners, and what it belongs to; empty where it does not.
    std::span<const core::Vec2f> uvs() const { return uvs_; }  // of each triangle's three corners
    std::span<const core::Rgbf> colours() const { return colours_; }  // likewise, linear
    std::span<const MeshGroup> groups() const { return groups_; }
    std::span<const std::uint32_t> groupOf() const { return groupOf_; }  // of each triangle in groups()

    // Where its own space begins, in that of the vertices it was given: in its middle, if it lies farther away than it
    // is large. All its coordinates are relative to this.
    const glm::dvec3& origin() const { return origin_; }
    core::Bounds bounds() const { return bounds_; }
    core::Vec3f reachUnder(const core::Transform& map) const { return reachOfBox(map, bounds_.size() * 0.5f); }
    std::vector<FlatSide> flatSides() const;  // each triangle
    std::size_t triangleCount() const { return triangleCount_; }
    core::Vec3f vertex(std::uint32_t triangle, int corner) const;
    std::span<const PackedNormal> normals() const { return normals_; }  // of each triangle's three corners, or none
    std::size_t bytes() const;

private:
    template<class Real>
    core::Vec3<Real> cornerOf(const core::UInt<Real>& triangle, int corner) const;
    template<class Real>
    core::Vec3<Real> normalOf(const core::UInt<Real>& triangle, int corner) const;

    template<class Real>
    core::Vec2<Real> uvAt(const HitOf<Real>& hit) const;

    Polyhedron(const FlatMesh& mesh, std::vector<glm::ivec3> triangles);
    void setNormals(const FlatMesh& mesh, const std::vector<glm::ivec3>& triangles);
    void keepWhatIsKnown(const FlatMesh& mesh, const std::vector<glm::ivec3>& triangles);

    std::unique_ptr<TrianglePack[]> packs_;
    std::vector<PackedNormal> normals_;  // of each triangle's three corners, or empty
    std::vector<core::Vec2f> uvs_;  // likewise
    std::vector<core::Rgbf> colours_;  // likewise
    std::vector<MeshGroup> groups_;
    std::vector<std::uint32_t> groupOf_;  // of each triangle, or empty
    std::size_t triangleCount_ = 0;
    glm::dvec3 origin_{0};
    core::Bounds bounds_;
};

}  // namespace gr
