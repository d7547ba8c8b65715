// A polygon mesh, cut into triangles that know nothing of materials or places.
#pragma once

#include "core/ray.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gr {

struct Hit;
struct PackRay;
struct ShapePoint;
struct TrianglePack;

// Vertices and faces as a script gives them; a face lists its vertices, from 0, in the order of its outline.
struct PolygonMesh {
    std::vector<glm::dvec3> vertices;
    std::vector<std::vector<int>> faces;
};

// What was mended while a polyhedron was made.
struct MeshRepairs {
    int mergedVertices = 0;  // at the very place of an earlier one
    int droppedVertices = 0;  // repeated within a face, or there and straight back again
    int droppedFaces = 0;  // without area
    int turnedFaces = 0;  // wound against their neighbours

    std::string text() const;  // empty when nothing was mended
};

class Polyhedron {
public:
    // Throws core::Error for a face that is not simple (its outline crosses itself) and for a mesh without any area.
    // mesh: indices within range, finite coordinates, at least three indices to a face.
    ~Polyhedron();
    static std::shared_ptr<const Polyhedron> make(PolygonMesh mesh, MeshRepairs& repairs);

    // Replaces `nearest` by the hit of a triangle that comes before it. instance: what stands here for the polyhedron.
    void intersect(const PackRay& ray, std::uint32_t instance, Hit& nearest) const;
    bool occluded(const PackRay& ray) const;
    ShapePoint surfaceAt(const core::Rayf& ray, const Hit& hit, const core::Vec3f& margin) const;

    float extent() const { return extent_; }
    std::size_t triangleCount() const { return triangleCount_; }
    core::Vec3f vertex(std::uint32_t triangle, int corner) const;
    std::size_t bytes() const;

private:
    explicit Polyhedron(const std::vector<glm::dvec3>& vertices, const std::vector<glm::ivec3>& triangles);

    std::vector<TrianglePack> packs_;
    std::size_t triangleCount_ = 0;
    float extent_ = 0;  // the largest coordinate
};

}  // namespace gr
