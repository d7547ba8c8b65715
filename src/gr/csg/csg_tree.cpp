#include "gr/csg/csg_tree.h"

#include <algorithm>

namespace gr {

CsgTree::Link CsgTree::link(std::uint32_t parent) {
    if (parent == none) return {parent, false};
    Node& node = nodes_[parent];
    const bool isComplement = node.operation == CsgOperation::isDifference && node.children > 0;
    ++node.children;
    return {parent, isComplement, node.isInverted != isComplement};
}

std::uint32_t CsgTree::addNode(std::uint32_t parent, CsgOperation operation) {
    nodes_.push_back({link(parent), operation});
    return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void CsgTree::addOperand(std::uint32_t parent) {
    operands_.push_back(link(parent));
}

void CsgTree::finish() {
    // A node without children holds nothing: one is enough, and there is none.
    for (Node& node : nodes_)
        if (node.operation != CsgOperation::isUnion) node.enough = std::max(node.children, 1);
    for (const Link& operand : operands_) nodes_[operand.parent].counted += operand.isComplement;
    for (std::size_t i = nodes_.size(); i-- > 1;) {
        const Node& node = nodes_[i];
        nodes_[node.parent].counted += (node.counted >= node.enough) != node.isComplement;
    }
}

core::Bounds CsgTree::bounds(std::span<const core::Bounds> operands) const {
    const core::Bounds everywhere{core::Vec3f(-core::infinity), core::Vec3f(core::infinity)};
    std::vector<core::Bounds> boxes(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (nodes_[i].operation != CsgOperation::isUnion && nodes_[i].children > 0) boxes[i] = everywhere;
    const auto add = [&](const Link& link, const core::Bounds& box) {
        if (nodes_[link.parent].operation == CsgOperation::isUnion)
            boxes[link.parent].include(box);
        else if (!link.isComplement)
            boxes[link.parent] = boxes[link.parent].intersection(box);
    };
    for (std::size_t i = 0; i < operands_.size(); ++i) add(operands_[i], operands[i]);
    for (std::size_t i = nodes_.size(); i-- > 1;) add(nodes_[i], boxes[i].isEmpty() ? core::Bounds() : boxes[i]);
    return boxes[0];
}

CsgState::CsgState(const CsgTree& tree, std::vector<std::int32_t>& counted) : tree_(tree), counted_(counted) {
    counted_.resize(tree.nodes_.size());
    std::transform(tree.nodes_.begin(), tree.nodes_.end(), counted_.begin(),
                   [](const CsgTree::Node& node) { return node.counted; });
    isInside_ = holds(0);
}

void CsgState::cross(std::size_t operand, bool enters) {
    const CsgTree::Link* link = &tree_.operands_[operand];
    bool isMore = enters != link->isComplement;
    // As long as nodes change with it, their parents must be told.
    for (std::uint32_t node = link->parent;; node = link->parent) {
        const bool before = holds(node);
        counted_[node] += isMore ? 1 : -1;
        const bool after = holds(node);
        if (before == after) return;
        if (node == 0) {
            isInside_ = after;
            return;
        }
        link = &tree_.nodes_[node];
        isMore = after != link->isComplement;
    }
}

}  // namespace gr
