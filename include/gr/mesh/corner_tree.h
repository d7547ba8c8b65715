// Which corners of an outline lie in a triangle.
#pragma once

#include "gr/mesh/outline.h"

#include <algorithm>
#include <span>
#include <utility>

namespace gr {

// Corners in boxes, halved along their longer side until few are left in each. Corners can be taken out, not put in.
class CornerTree {
public:
    static constexpr int none = -1;

    CornerTree(const Outline& outline, std::vector<int> corners) : outline_(outline), corners_(std::move(corners)) {
        leafOf_.assign(outline.size(), none);
        if (!corners_.empty()) build(0, static_cast<int>(corners_.size()), none);
    }

    // corner: one of those given, or any other, which changes nothing.
    void remove(int corner) {
        for (int node = std::exchange(leafOf_[corner], none); node != none; node = nodes_[node].parent)
            --nodes_[node].count;
    }

    // One that lies in the triangle a, b, c, which turns left, or on its sides; or none. One at the same place as a, b
    // or c does not count.
    int findIn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) const {
        return nodes_.empty() ? none : findIn(0, {a, b, c});
    }

private:
    static constexpr int mostInLeaf = 8;

    struct Node {
        glm::dvec2 low, high;
        int first, end;  // of its corners
        int parent;
        int second;  // its second half; its first one follows it; none: it is a leaf
        int count;  // of the corners that are left
    };
    struct Triangle {
        glm::dvec2 a, b, c;

        bool holds(const glm::dvec2& p) const {
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        }
        // False only when no point in the box is held: rounding is monotonic, so that no point in it can be found
        // farther to the left of a side than the box's own corner there.
        bool mayMeet(const Node& box) const {
            const auto isOnSide = [&](const glm::dvec2& from, const glm::dvec2& to) {
                return turn(from, to,
                            {to.y > from.y ? box.low.x : box.high.x, to.x > from.x ? box.high.y : box.low.y}) >= 0;
            };
            const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
            return low.x <= box.high.x && low.y <= box.high.y && high.x >= box.low.x && high.y >= box.low.y &&
                   isOnSide(a, b) && isOnSide(b, c) && isOnSide(c, a);
        }
    };

    int build(int first, int end, int parent) {
        const int number = static_cast<int>(nodes_.size());
        Node node{outline_[corners_[first]], outline_[corners_[first]], first, end, parent, none, end - first};
        for (const int corner : std::span(corners_).subspan(first, end - first)) {
            node.low = glm::min(node.low, outline_[corner]);
            node.high = glm::max(node.high, outline_[corner]);
        }
        nodes_.push_back(node);
        if (end - first <= mostInLeaf) {
            for (int i = first; i < end; ++i) leafOf_[corners_[i]] = number;
            return number;
        }
        const int axis = node.high.x - node.low.x >= node.high.y - node.low.y ? 0 : 1, middle = (first + end) / 2;
        std::nth_element(&corners_[first], &corners_[middle], &corners_[0] + end,
                         [&](int i, int j) { return outline_[i][axis] < outline_[j][axis]; });
        build(first, middle, number);
        const int second = build(middle, end, number);
        nodes_[number].second = second;
        return number;
    }

    int findIn(int number, const Triangle& triangle) const {
        const Node& node = nodes_[number];
        if (node.count == 0 || !triangle.mayMeet(node)) return none;
        if (node.second != none) {
            const int found = findIn(number + 1, triangle);
            return found != none ? found : findIn(node.second, triangle);
        }
        for (int i = node.first; i < node.end; ++i)
            if (leafOf_[corners_[i]] != none && triangle.holds(outline_[corners_[i]])) return corners_[i];
        return none;
    }

    const Outline& outline_;
    std::vector<int> corners_;  // leaf by leaf
    std::vector<int> leafOf_;  // of each corner of the outline; none: taken out
    std::vector<Node> nodes_;
};

}  // namespace gr
