// Constructive solid geometry: which places a solid holds, given which of its operands hold them.
#pragma once

#include "core/bounds.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gr {

enum class CsgOperation { isUnion, isIntersection, isDifference };

// A tree of operations, at whose ends are operands, numbered in the order in which they are added. Each node counts
// how many of its children hold a place, and holds it itself where they are enough: one of a union, all of an
// intersection. A difference is the intersection of its first child and of what all others leave out.
class CsgTree {
public:
    static constexpr std::uint32_t none = ~0u;

    // Each adds a child of the node `parent`, behind those that it has. The first node, of parent none, is the whole.
    std::uint32_t addNode(std::uint32_t parent, CsgOperation operation);  // returns its number
    void addOperand(std::uint32_t parent);
    // To be called once, after all were added.
    void finish();

    std::size_t operandCount() const { return operands_.size(); }
    // Whether the outside of an operand is what the whole may hold: its surface then looks the other way.
    bool isInverted(std::size_t operand) const { return operands_[operand].isInverted; }
    // Of a tree of few operands: whether it holds a place, for each way in which they may hold it. The number of such a
    // way, and of the bit that tells, has a bit for each operand that holds, the first one's last.
    static constexpr std::uint32_t mostInTable = 5;
    std::uint32_t table() const { return table_; }
    // A box round the whole, given those of its operands; infinite along axes where none bounds it.
    core::Bounds bounds(std::span<const core::Bounds> operands) const;
    // Calls f(number) with numbers that tell it from other trees.
    template<class F>
    void forEachNumber(F&& f) const {
        for (const Node& node : nodes_) {
            f(node.parent);
            f(static_cast<std::uint32_t>(node.operation));
        }
        for (const Link& operand : operands_) f(operand.parent);
    }
    std::size_t bytes() const {
        return nodes_.capacity() * sizeof(Node) + operands_.capacity() * sizeof(Link) +
               farAway_.capacity() * sizeof(farAway_[0]);
    }

private:
    friend class CsgState;

    struct Link {
        std::uint32_t parent;
        bool isComplement;  // the parent counts where it does not hold
        bool isInverted = false;
    };
    struct Node : Link {
        CsgOperation operation;
        std::int32_t children = 0;
        std::int32_t enough = 1;  // how many of them must count
    };

    Link link(std::uint32_t parent);
    void fillTable();

    std::vector<Node> nodes_;  // parents first
    std::vector<Link> operands_;
    std::vector<std::int32_t> farAway_;  // how many of each node's children count where no operand holds
    std::uint32_t table_ = 0;
};

// What the whole holds on the way along a ray, as it goes into operands and out of them.
class CsgState {
public:
    // What it works with, to be used again and again: lists that it leaves as it finds them.
    struct Room {
        std::vector<std::int32_t> counted;  // of each node's children
        std::vector<std::int32_t> windings;  // how many times the way is inside of an operand; 0 between two ways

        void fit(const CsgTree& tree) {
            if (windings.size() < tree.operandCount()) windings.resize(tree.operandCount(), 0);
        }
    };

    // Far away. The room must fit the tree.
    CsgState(const CsgTree& tree, Room& room) : tree_(tree), room_(room) {
        room_.counted = tree.farAway_;
        isInside_ = holds(0);
    }

    bool isInside() const { return isInside_; }
    // Goes into an operand, or out of it. A mesh may be entered before it is left.
    void cross(std::size_t operand, bool enters) {
        std::int32_t& winding = room_.windings[operand];
        const bool before = winding > 0;
        winding += enters ? 1 : -1;
        if (before != (winding > 0)) turn(operand, !before);
    }
    // To be called of each operand that was crossed, when the way is at its end.
    void forget(std::size_t operand) { room_.windings[operand] = 0; }

private:
    bool holds(std::uint32_t node) const { return room_.counted[node] >= tree_.nodes_[node].enough; }

    // The way is now inside of an operand that it was outside of, or the other way round.
    void turn(std::size_t operand, bool isIn) {
        const CsgTree::Link* link = &tree_.operands_[operand];
        bool isMore = isIn != link->isComplement;
        // As long as nodes change with it, their parents must be told.
        for (std::uint32_t node = link->parent;; node = link->parent) {
            const bool before = holds(node);
            room_.counted[node] += isMore ? 1 : -1;
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

    const CsgTree& tree_;
    Room& room_;
    bool isInside_;
};

}  // namespace gr
