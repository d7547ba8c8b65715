// From a glTF file's scene to one list of faces.
#pragma once

#include "gr/mesh/import/gltf/instances.h"
#include "gr/mesh/import/gltf/node_tree.h"
#include "gr/mesh/import/gltf/primitive_placer.h"

#include <map>
#include <set>

namespace gr::importer {

class ScenePlacer {
public:
    ScenePlacer(const GltfDocument& document, GltfBuffers& buffers)
        : document_(document), buffers_(buffers), tree_(document), placer_(mesh_) {}

    // Call it once. Throws Failure.
    SourceMesh build();

private:
    // Nodes that are alike in these share what is read.
    struct Use {
        std::size_t mesh = 0;
        bool isSkinned = false;
        std::vector<double> weights;
        auto operator<=>(const Use&) const = default;
    };
    // What is read goes when its last node has been placed.
    struct Shared {
        std::size_t nodesLeft = 0;
        std::optional<std::vector<Primitive>> primitives;
    };
    struct Placed {
        std::size_t node = 0;
        std::map<Use, Shared>::iterator use;
    };

    std::vector<Placed> placedMeshes();
    std::vector<Primitive> readPrimitives(const Use& use);
    void place(std::size_t nodeIndex, const JsonObject& mesh, const std::vector<Primitive>& primitives);
    void placeInstances(const JsonObject& node, const glm::dmat4& matrix, const std::string& name,
                        const std::vector<Primitive>& primitives);
    void placeSkinned(const JsonObject& node, std::size_t skin, const std::string& name,
                      const std::vector<Primitive>& primitives);
    void countLinesAndPoints(const std::vector<Primitive>& primitives, std::size_t times);

    const GltfDocument& document_;
    GltfBuffers& buffers_;
    NodeTree tree_;
    SourceMesh mesh_;
    PrimitivePlacer placer_;
    std::map<Use, Shared> uses_;
    std::map<std::size_t, std::vector<glm::dmat4>> joints_;  // of the skins that were needed so far
};

}  // namespace gr::importer
