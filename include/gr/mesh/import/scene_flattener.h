// From assimp's tree of meshes to one list of faces.
#pragma once

#include "gr/mesh/octahedral.h"
#include "gr/mesh/places.h"

#include <assimp/scene.h>

#include <stdexcept>
#include <vector>

namespace gr::importer {

// What is wrong with a file, in words for a person.
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// All faces of a scene, each mesh at every place where the tree has it. Vertices at the same place become one.
class SceneFlattener {
public:
    // Throws Failure.
    SceneFlattener(const aiScene& scene, bool withNormals);

    std::vector<core::Vec3f> vertices;
    std::vector<int> corners;
    std::vector<int> ends;  // empty where all faces are triangles
    std::vector<PackedNormal> normals;  // of the corners, or empty
    std::uint32_t linesAndPoints = 0;  // left out

private:
    struct Placed {
        const aiMesh* mesh;
        aiMatrix4x4t<double> matrix;
    };

    std::vector<Placed> placedMeshes(const aiScene& scene) const;
    void add(const Placed& placed);
    void addVertices(const Placed& placed);
    int addVertex(const core::Vec3f& vertex, std::uint64_t hash);
    void addNormals(const Placed& placed);
    void addFace(const aiFace& face, bool isMirrored);
    void endFace(std::size_t firstCorner);

    bool withNormals_;
    PlaceTable<core::Vec3f> table_;
    // Of the vertices of the mesh that is being added:
    std::vector<int> numbers_;
    std::vector<PackedNormal> packed_;  // empty: it has no normals
};

}  // namespace gr::importer
