#include "gr/mesh/import/gltf/skin.h"

namespace gr::importer {

std::vector<glm::dmat4> jointMatrices(const GltfDocument& document, GltfBuffers& buffers, const NodeTree& tree,
                                      std::size_t skin) {
    const JsonObject object = document.item(skinKind, skin);
    const std::vector<std::size_t> joints = document.allNamed(object, "joints", nodeKind);
    std::vector<glm::dmat4> matrices;
    matrices.reserve(joints.size());
    for (const std::size_t node : joints) matrices.push_back(tree.matrix(node));
    const std::optional<std::size_t> index = document.named(object, "inverseBindMatrices", accessorKind);
    if (!index) return matrices;
    const Accessor inverses = readAccessor(document, buffers, *index);
    inverses.expectType("inverseBindMatrices", {"MAT4"});
    if (inverses.count < joints.size())
        throw Failure(object.subject() + " has " + std::to_string(joints.size()) +
                      " joints, but inverseBindMatrices for " + std::to_string(inverses.count));
    for (std::size_t i = 0; i < joints.size(); ++i)
        matrices[i] *= affine([&](std::size_t k) { return inverses.number(i, k); });
    return matrices;
}

}  // namespace gr::importer
