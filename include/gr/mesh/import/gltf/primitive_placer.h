// Primitives at their places in the scene.
#pragma once

#include "gr/mesh/import/gltf/primitive.h"

namespace gr::importer {

// Adds primitives to a mesh, as groups of their own.
class PrimitivePlacer {
public:
    explicit PrimitivePlacer(SourceMesh& mesh) : mesh_(mesh) {}

    // All vertices moved by one matrix. Faces that it mirrors are turned, so that their fronts stay in front.
    void place(const Primitive& primitive, const std::string& name, const glm::dmat4& matrix);
    // Each vertex moved by the joints that influence it.
    void placeSkinned(const Primitive& primitive, const std::string& name, const std::vector<glm::dmat4>& joints);

private:
    void begin(const Primitive& primitive);
    void addVertex(const Primitive& primitive, std::size_t vertex, const glm::dmat4& matrix,
                   const glm::dmat3& cofactors);
    void addFaces(const Primitive& primitive, const std::string& name);
    void addCorner(const Primitive& primitive, std::uint32_t vertex);

    SourceMesh& mesh_;
    // Of the primitive that is being placed:
    int firstVertex_ = 0;
    std::vector<PackedNormal> normals_;  // of its vertices, or empty
    std::vector<bool> isMirrored_;  // of its vertices, or one for all
};

}  // namespace gr::importer
