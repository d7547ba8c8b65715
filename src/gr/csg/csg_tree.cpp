#include "gr/csg/csg_tree.h"

#include <algorithm>
#include <bit>

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
    farAway_.resize(nodes_.size());
    for (const Link& operand : operands_) farAway_[operand.parent] += operand.isComplement;
    for (std::size_t i = nodes_.size(); i-- > 1;) {
        const Node& node = nodes_[i];
        farAway_[node.parent] += (farAway_[i] >= node.enough) != node.isComplement;
    }
    if (operands_.size() <= mostInTable) fillTable();
}

void CsgTree::fillTable() {
    CsgState::Room room;
    room.fit(*this);
    CsgState state(*this, room);
    // From one way to the next a single operand changes, in Gray's order.
    std::uint32_t way = 0;
    const std::uint32_t count = 1u << operands_.size();
    for (std::uint32_t i = 1;; ++i) {
        table_ |= std::uint32_t{state.isInside()} << way;
        if (i == count) return;
        const int operand = std::countr_zero(i);
        way ^= 1u << operand;
        state.cross(static_cast<std::size_t>(operand), (way >> operand & 1) != 0);
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

}  // namespace gr
