// A search among boxes.
#pragma once

#include "core/vec.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace gr {

struct Box {
    glm::dvec3 low{core::infinity}, high{-core::infinity};

    void include(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void include(const Box& box) {
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    bool holds(const Box& box) const {
        return glm::all(glm::lessThanEqual(low, box.low)) && glm::all(glm::greaterThanEqual(high, box.high));
    }
};

// A binary tree of boxes, halved along the longest side of what they lie in.
class BoxTree {
public:
    explicit BoxTree(const std::vector<Box>& boxes) : order_(boxes.size()), nodes_(2 * boxes.size()) {
        std::iota(order_.begin(), order_.end(), 0);
        if (!boxes.empty()) build(boxes, 0, 0, static_cast<int>(boxes.size()));
    }

    // Calls function(i) for all boxes i that pass. passes(box): true also for any box round one that passes.
    template<class Passes, class Function>
    void forEach(Passes&& passes, Function&& function) const {
        if (!order_.empty()) visit(0, 0, static_cast<int>(order_.size()), passes, function);
    }

private:
    // A node of n boxes is followed by its first half's 2 (n / 2) - 1 nodes, and these by its second half's.
    static int secondOf(int node, int first, int middle) { return node + 2 * (middle - first); }

    void build(const std::vector<Box>& boxes, int node, int first, int end) {
        if (end - first == 1) {
            nodes_[node] = boxes[order_[first]];
            return;
        }
        Box middles;
        for (int i = first; i < end; ++i) middles.include(middleOf(boxes[order_[i]]));
        const glm::dvec3 size = middles.high - middles.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0
                         : size.y >= size.z                   ? 1
                                                              : 2,
                  middle = (first + end) / 2;
        std::nth_element(&order_[first], &order_[middle], &order_[0] + end,
                         [&](int a, int b) { return middleOf(boxes[a])[axis] < middleOf(boxes[b])[axis]; });
        build(boxes, node + 1, first, middle);
        build(boxes, secondOf(node, first, middle), middle, end);
        nodes_[node] = nodes_[node + 1];
        nodes_[node].include(nodes_[secondOf(node, first, middle)]);
    }

    template<class Passes, class Function>
    void visit(int node, int first, int end, Passes& passes, Function& function) const {
        if (!passes(nodes_[node])) return;
        if (end - first == 1) return function(order_[first]);
        const int middle = (first + end) / 2;
        visit(node + 1, first, middle, passes, function);
        visit(secondOf(node, first, middle), middle, end, passes, function);
    }

    static glm::dvec3 middleOf(const Box& box) { return 0.5 * (box.low + box.high); }

    std::vector<int> order_;  // the boxes' numbers, leaf by leaf
    std::vector<Box> nodes_;
};

}  // namespace gr
