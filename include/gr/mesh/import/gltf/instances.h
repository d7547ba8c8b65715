// EXT_mesh_gpu_instancing: a node whose mesh stands at many places.
#pragma once

#include "gr/mesh/import/gltf/accessor.h"

namespace gr::importer {

class Instances {
public:
    // A node without the extension has one, which is where the node is.
    Instances(const GltfDocument& document, GltfBuffers& buffers, const JsonObject& node);

    std::size_t count() const { return count_; }
    // From an instance's space to its node's.
    glm::dmat4 matrix(std::size_t instance) const;

private:
    std::string place_;
    std::size_t count_ = 1;
    std::optional<Accessor> translations_, rotations_, scales_;
};

}  // namespace gr::importer
