// From nodes of the scene graph to CSG objects, while a scene is compiled.
#pragma once

#include "gr/database/node.h"
#include "gr/scene.h"

#include <functional>
#include <optional>
#include <unordered_set>

namespace gr {

// The operation that a node stands for, if it is one.
std::optional<CsgOperation> operationOf(const NodeContent& content);

// One CSG object after the other: each is begun with its top node, given its operands in their order, and finished. All
// throw core::Error for what cannot be an operand, or a whole.
class CsgBuilder {
public:
    using NameOf = std::function<std::string(std::uint32_t material)>;

    // The scene must outlive it.
    explicit CsgBuilder(Scene& scene) : scene_(scene) {}

    void begin(const Node& top) { open_.emplace(&top, static_cast<std::uint32_t>(scene_.instances.size())); }
    // A node of its tree below `parent`, or none for the first.
    std::uint32_t addNode(std::uint32_t parent, CsgOperation operation) {
        return open_->tree.addNode(parent, operation);
    }
    // The scene's newest instance becomes an operand. node: its own.
    void addOperand(const Node& node, std::uint32_t parent);
    // Where it is complete: itself, as no instance yet, or null if it holds nothing. nameOf: for messages.
    std::unique_ptr<Csg> finish(const NameOf& nameOf);
    // What is inside of the one that was finished last: that material of its operands that has an interior, if any has.
    std::uint32_t materialInside() const { return materialInside_; }
    // How many have been finished.
    std::uint32_t count() const { return count_; }

private:
    struct Open {
        Open(const Node* top, std::uint32_t first) : top(top), first(first) {}

        const Node* top;
        std::uint32_t first;  // its first operand's instance
        CsgTree tree;
    };

    void checkSolid(const Node& node);
    std::uint32_t findMaterialInside(const Open& open, const NameOf& nameOf) const;

    Scene& scene_;
    std::optional<Open> open_;
    std::uint32_t count_ = 0, materialInside_ = 0;
    std::unordered_set<const Polyhedron*> closedMeshes_;
};

// To be called when all operands stand where they stay. boxes: of all instances, which are kept true.
void finishCsgs(Scene& scene, std::vector<core::Bounds>& boxes);

}  // namespace gr
