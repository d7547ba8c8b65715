#include "gr/accelerators/median_tree.h"

#include <algorithm>
#include <array>

namespace gr {
namespace {

class MedianBuilder {
public:
    MedianBuilder(std::uint32_t count, const WideTree::BoundsOf& boundsOf, const WideTree::MakeLeaf& makeLeaf,
                  TreeMemory& memory)
        : makeLeaf_(makeLeaf), allocate_([&memory](std::size_t bytes) { return memory.allocate(bytes); }) {
        for (std::uint32_t i = 0; i < count; ++i) items_.push_back({boundsOf(i), i});
    }

    TreeReference build() { return build({0, items_.size()}); }

private:
    struct Item {
        core::Bounds bounds;
        std::uint32_t number;
        core::Vec3f middle() const { return bounds.low * 0.5f + bounds.high * 0.5f; }
    };
    struct Range {
        std::size_t begin, end;  // in items_
        std::size_t size() const { return end - begin; }
    };

    TreeReference build(Range range) {
        if (range.size() <= treeWidth) return leaf(range);
        std::array<Range, treeWidth> parts{range};
        int count = 1;
        for (; count < treeWidth; ++count) {
            const auto isSmaller = [](const Range& a, const Range& b) { return a.size() < b.size(); };
            Range& largest = *std::max_element(parts.begin(), parts.begin() + count, isSmaller);
            if (largest.size() <= treeWidth) break;
            parts[count] = cut(largest);
        }
        auto* node = static_cast<TreeNode*>(allocate_(sizeof(TreeNode)));
        node->clear();
        for (int i = 0; i < count; ++i) {
            core::Bounds bounds;
            for (std::size_t k = parts[i].begin; k < parts[i].end; ++k) bounds.include(items_[k].bounds);
            node->set(i, bounds, build(parts[i]));
        }
        return {node, TreeReference::node};
    }

    // Keeps the first half of a range and returns the other.
    Range cut(Range& range) {
        core::Bounds middles;
        for (std::size_t i = range.begin; i < range.end; ++i) middles.include(items_[i].middle());
        const core::Vec3f size = middles.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t median = (range.begin + range.end) / 2;
        const auto at = [&](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(range.begin), at(median), at(range.end),
                         [&](const Item& a, const Item& b) { return a.middle()[axis] < b.middle()[axis]; });
        const Range rest{median, range.end};
        range.end = median;
        return rest;
    }

    TreeReference leaf(Range range) {
        std::array<std::uint32_t, treeWidth> numbers;
        for (std::size_t i = 0; i < range.size(); ++i) numbers[i] = items_[range.begin + i].number;
        return makeLeaf_({numbers.data(), range.size()}, allocate_);
    }

    const WideTree::MakeLeaf& makeLeaf_;
    const WideTree::Allocate allocate_;
    std::vector<Item> items_;
};

}  // namespace

TreeReference medianTree(std::uint32_t count, const WideTree::BoundsOf& boundsOf, const WideTree::MakeLeaf& makeLeaf,
                         TreeMemory& memory) {
    return MedianBuilder(count, boundsOf, makeLeaf, memory).build();
}

}  // namespace gr
