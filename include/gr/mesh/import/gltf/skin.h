// Skins: vertices that joints move.
#pragma once

#include "gr/mesh/import/gltf/accessor.h"
#include "gr/mesh/import/gltf/node_tree.h"

namespace gr::importer {

// One for each joint of a skin, from the mesh's space, as it was bound, to the scene's.
std::vector<glm::dmat4> jointMatrices(const GltfDocument& document, GltfBuffers& buffers, const NodeTree& tree,
                                      std::size_t skin);

}  // namespace gr::importer
