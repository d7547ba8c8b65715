// How a ray goes through a tree. To be compiled for each instruction set: Lanes are 4 or 8 floats.
#pragma once

#include "core/ray.h"
#include "gr/accelerators/wide_tree.h"

#include <limits>

namespace gr {

// How many boxes are tested at once: all of a node's, if the processor can.
#ifdef __AVX2__
using TreeLanes = xsimd::make_sized_batch_t<float, treeWidth>;
#else
using TreeLanes = xsimd::batch<float>;
#endif

// A ray with what the tests of boxes and triangles divide by, its coordinates side by side, to be computed at once.
struct ReadyRay {
    using Row = xsimd::make_sized_batch_t<float, 4>;
    Row origin, direction, inverse;

    ReadyRay(const Row& origin, const Row& direction)
        // Finite, so that no product is not a number.
        : origin(origin),
          direction(direction),
          inverse(core::min(core::max(Row(1.f) / direction, Row(-most)), Row(most))) {}
    explicit ReadyRay(const core::Rayf& ray)
        : ReadyRay(Row{ray.origin.x, ray.origin.y, ray.origin.z, 0},
                   Row{ray.direction.x, ray.direction.y, ray.direction.z, 1}) {}

    static constexpr float most = std::numeric_limits<float>::max();
};

// A ray made ready to be tested against boxes (Kay and Kajiya 1986), each of them larger by a slack on all sides. The
// way to a side is side * inverse - origin * inverse, in which the slack has room for what is rounded.
template<class Lanes>
class BoxRay {
public:
    BoxRay(const ReadyRay& ray, float slack) {
        using Row = ReadyRay::Row;
        const Row outwards = core::select(ray.inverse < Row(0.f), Row(-slack), Row(slack));
        const core::LaneArray<Row> near((ray.origin + outwards) * ray.inverse),
            far((ray.origin - outwards) * ray.inverse), inverse(ray.inverse);
        for (int axis = 0; axis < 3; ++axis) set(axis, inverse[axis], near[axis], far[axis]);
    }
    BoxRay() = default;

    // near, far: its origin, a slack before and behind, times the inverse of its direction along the axis.
    void set(int axis, float inverse, float near, float far) {
        const bool isBackwards = inverse < 0;
        nearSide_[axis] = offsetof(TreeNode, side) + sizeof(TreeNode::side[0]) * static_cast<std::size_t>(axis) +
                          (isBackwards ? sizeof(TreeNode::side[0][0]) : 0);
        farSide_[axis] = nearSide_[axis] + (isBackwards ? -sizeof(TreeNode::side[0][0]) : sizeof(TreeNode::side[0][0]));
        inverse_[axis] = Lanes(inverse);
        near_[axis] = Lanes(near);
        far_[axis] = Lanes(far);
    }

    // A bit for each child whose box the ray meets at t <= end, and where it enters it.
    std::uint32_t meet(const TreeNode& node, float end, float* entry) const {
        constexpr int width = static_cast<int>(Lanes::size);
        std::uint32_t met = 0;
        for (int first = 0; first < treeWidth; first += width) {
            const auto wayTo = [&](std::size_t side, int axis, const Lanes& origin) {
                const char* row = reinterpret_cast<const char*>(&node) + side;
                return xsimd::fms(Lanes::load_aligned(reinterpret_cast<const float*>(row) + first), inverse_[axis],
                                  origin);
            };
            // What is not a number, infinity less infinity, leaves the other: xsimd's min and max give the second word.
            Lanes enter(0.f), leave(end);
            for (int axis = 0; axis < 3; ++axis) {
                enter = xsimd::max(wayTo(nearSide_[axis], axis, near_[axis]), enter);
                leave = xsimd::min(wayTo(farSide_[axis], axis, far_[axis]), leave);
            }
            enter.store_aligned(entry + first);
            met |= core::bitsOf(enter <= leave) << first;
        }
        return met;
    }

private:
    std::size_t nearSide_[3], farSide_[3];  // of a node, in bytes from its start
    Lanes inverse_[3], near_[3], far_[3];
};

// A ray made ready for a tree.
template<class Lanes>
BoxRay<Lanes> boxRayFor(const WideTree& tree, const ReadyRay& ray) {
    const core::LaneArray<ReadyRay::Row> origin(core::abs(ray.origin));
    return {ray, tree.slack(core::max(core::max(origin[0], origin[1]), origin[2]))};
}

// Asks the memory for a child before it is looked at. Inlined, since GCC takes a call that only does this for one that
// does nothing.
[[gnu::always_inline]] inline void prefetch(TreeReference child) {
    for (std::size_t line = 0; line < 320; line += 64)
        __builtin_prefetch(static_cast<const char*>(child.address()) + line);
}

// Calls visit(leaf) for the leaves whose boxes the ray meets, near ones first, until it returns true or nothing at most
// as far as `nearest`, which visit may lower, can follow. Returns whether visit did.
template<class Lanes, class Visit>
bool walkTree(TreeReference root, const BoxRay<Lanes>& ray, const float& nearest, Visit&& visit) {
    struct Entry {
        float t;
        TreeReference reference;
    };
    // Of each node on the way down all children but the one that is entered wait here.
    Entry stack[(treeWidth - 1) * mostTreeDepth + 1];
    int waiting = 0;
    TreeReference at = root;
    for (;;) {
        while (!at.isLeaf()) {
            const TreeNode& node = *static_cast<const TreeNode*>(at.address());
            alignas(32) float entry[treeWidth];
            std::uint32_t met = ray.meet(node, nearest, entry);
            if (met == 0) break;
            // Enter the nearest, and let the others wait, the farther the longer.
            int child = std::countr_zero(met);
            at = node.child[child];
            float t = entry[child];
            const int bottom = waiting;
            for (met &= met - 1; met != 0; met &= met - 1) {
                child = std::countr_zero(met);
                Entry next{entry[child], node.child[child]};
                prefetch(next.reference);
                if (next.t < t) {
                    std::swap(next.t, t);
                    std::swap(next.reference, at);
                }
                int place = waiting++;
                for (; place > bottom && stack[place - 1].t < next.t; --place) stack[place] = stack[place - 1];
                stack[place] = next;
            }
            prefetch(at);
        }
        if (at.isLeaf() && at.address() != nullptr && visit(at.address())) return true;
        do {
            if (waiting == 0) return false;
            at = stack[--waiting].reference;
        } while (stack[waiting].t > nearest);
    }
}

}  // namespace gr
