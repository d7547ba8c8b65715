#include "gr/mesh/import/gltf/node_tree.h"

#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

namespace gr::importer {
namespace {

glm::dmat4 ownMatrix(const JsonObject& node) {
    const std::vector<double> numbers = node.numbers("matrix", 16);
    if (numbers.empty())
        return transformOf(node.numbers("translation", 3), node.numbers("rotation", 4), node.numbers("scale", 3),
                           node.place());
    return affine([&](std::size_t i) { return numbers[i]; });
}

}  // namespace

glm::dmat4 transformOf(const std::vector<double>& translation, const std::vector<double>& rotation,
                       const std::vector<double>& scale, const std::string& place) {
    glm::dmat3 turned(1);
    if (!rotation.empty()) {
        const glm::dquat quaternion(rotation[3], rotation[0], rotation[1], rotation[2]);
        const double length = glm::length(quaternion);
        if (!(length > 0)) throw Failure("its " + place + " has the rotation 0 0 0 0, which is none");
        turned = glm::mat3_cast(quaternion / length);
    }
    glm::dmat4 matrix(turned);
    for (int axis = 0; axis < 3 && !scale.empty(); ++axis) matrix[axis] *= scale[static_cast<std::size_t>(axis)];
    if (!translation.empty()) matrix[3] = {translation[0], translation[1], translation[2], 1};
    return matrix;
}

NodeTree::NodeTree(const GltfDocument& document)
    : document_(document), parents_(document.count(nodeKind), none), children_(parents_.size()) {
    findParents();
    findMatrices();
}

void NodeTree::findParents() {
    for (std::size_t node = 0; node < parents_.size(); ++node) {
        children_[node] = document_.allNamed(document_.item(nodeKind, node), "children", nodeKind);
        for (const std::size_t child : children_[node]) {
            if (parents_[child] != none)
                throw Failure("its node " + std::to_string(child) + " is a child of node " +
                              std::to_string(parents_[child]) + " and of node " + std::to_string(node));
            parents_[child] = node;
        }
    }
}

void NodeTree::findMatrices() {
    matrices_.resize(parents_.size());
    std::vector<bool> isReached(parents_.size());
    for (const std::size_t node : below(allRoots())) {
        isReached[node] = true;
        const glm::dmat4 own = ownMatrix(document_.item(nodeKind, node));
        matrices_[node] = parents_[node] == none ? own : matrices_[parents_[node]] * own;
    }
    for (std::size_t node = 0; node < isReached.size(); ++node)
        if (!isReached[node]) failCycle(node);
}

// A node that no root reaches is on a circle, or below one: as many steps upwards as there are nodes end on it.
void NodeTree::failCycle(std::size_t node) const {
    for (std::size_t step = 0; step < parents_.size(); ++step) node = parents_[node];
    throw Failure("its node " + std::to_string(node) + " is below itself");
}

std::vector<std::size_t> NodeTree::allRoots() const {
    std::vector<std::size_t> roots;
    for (std::size_t node = 0; node < parents_.size(); ++node)
        if (parents_[node] == none) roots.push_back(node);
    return roots;
}

std::vector<std::size_t> NodeTree::sceneRoots() const {
    std::optional<std::size_t> scene = document_.named(document_.root(), "scene", sceneKind);
    if (!scene && document_.count(sceneKind) > 0) scene = 0;
    if (!scene) return allRoots();
    const JsonObject object = document_.item(sceneKind, *scene);
    const std::vector<std::size_t> roots = document_.allNamed(object, "nodes", nodeKind);
    std::vector<bool> isNamed(parents_.size());
    for (const std::size_t node : roots) {
        if (parents_[node] != none)
            throw Failure(object.subject() + " names node " + std::to_string(node) + ", which is a child of node " +
                          std::to_string(parents_[node]));
        if (isNamed[node]) throw Failure(object.subject() + " names node " + std::to_string(node) + " twice");
        isNamed[node] = true;
    }
    return roots;
}

std::vector<std::size_t> NodeTree::sceneNodes() const {
    return below(sceneRoots());
}

// Those themselves and all below them. Without recursion: a file may have a node below a node a million times.
std::vector<std::size_t> NodeTree::below(const std::vector<std::size_t>& roots) const {
    std::vector<std::size_t> nodes, open(roots.rbegin(), roots.rend());
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        nodes.push_back(node);
        open.insert(open.end(), children_[node].rbegin(), children_[node].rend());
    }
    return nodes;
}

}  // namespace gr::importer
