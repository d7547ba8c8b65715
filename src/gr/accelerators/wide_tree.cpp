#include "gr/accelerators/wide_tree.h"

#include "core/fork_join.h"
#include "core/parallel.h"
#include "gr/accelerators/embree_library.h"
#include "gr/accelerators/median_tree.h"
#include "gr/mesh/parts.h"

#include <array>
#include <bit>
#include <limits>
#include <new>

namespace gr {

using core::Bounds;
using core::Vec3f;

namespace {

const EmbreeLibrary& embree() {
    return EmbreeLibrary::get();
}

// The power of two below a positive number.
float powerOfTwo(float x) {
    const float power = std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) & 0x7f800000u);
    return std::max(power, std::numeric_limits<float>::min());
}

// What Embree's builder calls to make nodes and leaves, from any thread. It knows a child by its reference's bits.
struct Builder {
    const WideTree::MakeLeaf& makeLeaf;
    float unit;  // of Embree's coordinates, in ours
    core::ForkJoin order = {};

    static const Builder& from(void* user) { return *static_cast<const Builder*>(user); }

    // Embree passes exceptions on, and tells of want of memory by a null.
    static void* allocate(RTCThreadLocalAllocator allocator, std::size_t bytes) {
        void* memory = embree().rtcThreadLocalAlloc(allocator, bytes, 64);
        if (memory == nullptr) throw std::bad_alloc();
        return memory;
    }

    static void* createNode(RTCThreadLocalAllocator allocator, unsigned, void* user) {
        const core::ForkJoin::Task here(from(user).order);
        auto* node = static_cast<TreeNode*>(allocate(allocator, sizeof(TreeNode)));
        node->clear();
        return node;
    }

    static void setChildren(void* node, void** children, unsigned count, void* user) {
        const core::ForkJoin::Task here(from(user).order);
        for (unsigned i = 0; i < count; ++i)
            static_cast<TreeNode*>(node)->child[i] = std::bit_cast<TreeReference>(children[i]);
    }

    static void setBounds(void* node, const RTCBounds** bounds, unsigned count, void* user) {
        const core::ForkJoin::Task here(from(user).order);
        const float unit = from(user).unit;
        auto& filled = *static_cast<TreeNode*>(node);
        for (unsigned i = 0; i < count; ++i) {
            const RTCBounds& b = *bounds[i];
            const Vec3f low(b.lower_x, b.lower_y, b.lower_z), high(b.upper_x, b.upper_y, b.upper_z);
            filled.set(static_cast<int>(i), {low * unit, high * unit}, filled.child[i]);
        }
    }

    static void* createLeaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count,
                            void* user) {
        const core::ForkJoin::Task here(from(user).order);
        std::array<std::uint32_t, treeWidth> items;
        for (std::size_t i = 0; i < count; ++i) items[i] = primitives[i].primID;
        const auto allocateHere = [&](std::size_t bytes) { return allocate(allocator, bytes); };
        return std::bit_cast<void*>(from(user).makeLeaf({items.data(), count}, allocateHere));
    }
};

}  // namespace

void TreeNode::clear() {
    for (int i = 0; i < treeWidth; ++i) set(i, core::Bounds(), TreeReference::nothing());
}

void TreeNode::set(int i, const core::Bounds& bounds, TreeReference reference) {
    for (int axis = 0; axis < 3; ++axis) {
        side[axis][0][i] = bounds.low[axis];
        side[axis][1][i] = bounds.high[axis];
    }
    child[i] = reference;
}

WideTree::WideTree(const EmbreeDevice* device, std::uint32_t count, const BoundsOf& boundsOf, const MakeLeaf& makeLeaf,
                   float errorPerUnit, int threads)
    : errorPerUnit_(errorPerUnit) {
    if (count == 0) return;
    for (const Bounds& part : ofParts<Bounds>(static_cast<int>(count), threads, [&](int first, int end) {
             Bounds box;
             for (int i = first; i < end; ++i) box.include(boundsOf(static_cast<std::uint32_t>(i)));
             return box;
         }))
        bounds_.include(part);
    reach_ = bounds_.reach();
    if (device != nullptr)
        buildByEmbree(*device, count, boundsOf, makeLeaf, threads);
    else
        root_ = medianTree(count, boundsOf, makeLeaf, own_);
}

void WideTree::buildByEmbree(const EmbreeDevice& device, std::uint32_t count, const BoundsOf& boundsOf,
                             const MakeLeaf& makeLeaf, int threads) {
    // Embree multiplies sizes, so it is given them as about 1. Powers of two round nothing.
    const float unit = powerOfTwo(reach_);
    std::vector<RTCBuildPrimitive> primitives(count);
    inParts(static_cast<int>(count), threads, [&](int first, int end) {
        for (int i = first; i < end; ++i) {
            const Bounds box = boundsOf(static_cast<std::uint32_t>(i));
            const Vec3f low = box.low * (1 / unit), high = box.high * (1 / unit);
            primitives[i] = {low.x, low.y, low.z, 0, high.x, high.y, high.z, static_cast<unsigned>(i)};
        }
    });

    Builder builder{makeLeaf, unit};
    bvh_ = embree().rtcNewBVH(device.get());
    if (bvh_ == nullptr) throw std::bad_alloc();
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = treeWidth;
    arguments.maxDepth = mostTreeDepth;
    arguments.sahBlockSize = treeWidth;
    arguments.minLeafSize = treeWidth;
    arguments.maxLeafSize = treeWidth;
    arguments.bvh = bvh_;
    arguments.primitives = primitives.data();
    arguments.primitiveCount = count;
    arguments.primitiveArrayCapacity = count;
    arguments.createNode = Builder::createNode;
    arguments.setNodeChildren = Builder::setChildren;
    arguments.setNodeBounds = Builder::setBounds;
    arguments.createLeaf = Builder::createLeaf;
    arguments.userPtr = &builder;
    // Embree, too, runs on TBB: as many threads as are allowed here.
    core::parallelFor(1, threads, [&](int) {
        builder.order.run([&] { root_ = std::bit_cast<TreeReference>(embree().rtcBuildBVH(&arguments)); });
    });
    try {
        device.check();
    } catch (...) {
        embree().rtcReleaseBVH(bvh_);
        throw;
    }
}

WideTree::~WideTree() {
    if (bvh_ != nullptr) embree().rtcReleaseBVH(bvh_);
}

}  // namespace gr
