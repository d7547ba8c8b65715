// A tree of boxes, eight to a node, so that one ray is tested against all eight at once; the same for what its leaves
// hold. Embree builds it, or for a few boxes we do (median_tree.h), and our own code walks it (wide_tree_walk.h): which
// boxes there are decides what is tested, never where a ray meets it.
#pragma once

#include "core/bounds.h"
#include "gr/accelerators/embree_device.h"
#include "gr/accelerators/tree_memory.h"

#include <cstdint>
#include <functional>
#include <span>

struct RTCBVHTy;

namespace gr {

// What a child of a node is: another node, a leaf, or nothing. Nodes and leaves lie at multiples of 64 bytes, so that
// an address has room for it.
class TreeReference {
public:
    enum Kind : std::uintptr_t { node = 0, leaf = 1 };

    TreeReference() = default;
    TreeReference(const void* address, Kind kind) : bits_(reinterpret_cast<std::uintptr_t>(address) | kind) {}

    static TreeReference nothing() { return {nullptr, leaf}; }

    bool isLeaf() const { return (bits_ & leaf) != 0; }
    // Null for nothing.
    const void* address() const { return reinterpret_cast<const void*>(bits_ & ~std::uintptr_t{leaf}); }

private:
    std::uintptr_t bits_;
};

// How many boxes a node has, and how many things a leaf's pack.
inline constexpr int treeWidth = 8;
// How deep a tree can become.
inline constexpr int mostTreeDepth = 48;

struct alignas(64) TreeNode {
    // [axis][side][child], side 0 being the low one. A child that is not there has its sides the wrong way round, so
    // that no ray meets it, but one whose numbers are none or overflow.
    float side[3][2][treeWidth];
    TreeReference child[treeWidth];

    void clear();
    void set(int i, const core::Bounds& bounds, TreeReference reference);
};
static_assert(sizeof(TreeNode) == 256);

class WideTree {
public:
    // A leaf of the items, at most treeWidth of them, or a node over leaves, put into memory that allocate(bytes)
    // gives, at a multiple of 64. Called by many threads at once.
    using Allocate = std::function<void*(std::size_t bytes)>;
    using MakeLeaf = std::function<TreeReference(std::span<const std::uint32_t> items, const Allocate& allocate)>;
    using BoundsOf = std::function<core::Bounds(std::uint32_t)>;

    // boundsOf: of the items 0 to count - 1. They hold every point at which an item may be reported to be hit by a ray
    // that starts at the origin; one that starts or hits at distance x from there may be off by errorPerUnit * x more.
    // The device builds it and must outlive it; null: halves of halves (median_tree.h). threads: for the device.
    WideTree(const EmbreeDevice* device, std::uint32_t count, const BoundsOf& boundsOf, const MakeLeaf& makeLeaf,
             float errorPerUnit, int threads);
    ~WideTree();
    WideTree(const WideTree&) = delete;
    WideTree& operator=(const WideTree&) = delete;

    TreeReference root() const { return root_; }  // nothing for no items
    const core::Bounds& bounds() const { return bounds_; }  // of all items
    std::size_t bytes() const { return own_.bytes(); }  // what the device has is not counted

    // How much larger all boxes are for a ray that starts so far from the origin (the largest of its coordinates): by
    // what rounding may move the ray and what it hits, and by what the test of a box itself rounds. On its way a ray is
    // never farther away than where it starts and where it hits together.
    template<class Real>
    Real slack(const Real& distance) const {
        return (distance + Real(reach_)) * Real(2 * (errorPerUnit_ + 0x1p-21f));
    }

private:
    void buildByEmbree(const EmbreeDevice& device, std::uint32_t count, const BoundsOf& boundsOf,
                       const MakeLeaf& makeLeaf, int threads);

    // Nodes and leaves are owned by one of the two.
    RTCBVHTy* bvh_ = nullptr;
    TreeMemory own_;
    TreeReference root_ = TreeReference::nothing();
    core::Bounds bounds_;
    float errorPerUnit_, reach_ = 0;
};

}  // namespace gr
