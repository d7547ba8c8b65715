// How a ray goes through a tree. To be compiled for each instruction set: Lanes are 4 or 8 floats.
#pragma once

#include "core/ray.h"
#include "gr/accelerators/wide_tree.h"

#include <limits>

namespace gr {

// A ray made ready to be tested against boxes (Kay and Kajiya 1986), each of them larger by `slack` on all sides.
template<class Lanes>
class BoxRay {
public:
    BoxRay(const core::Rayf& ray, float slack) {
        // Finite, so that no product is not a number.
        constexpr float most = std::numeric_limits<float>::max();
        for (int axis = 0; axis < 3; ++axis) {
            const float inverse = core::min(core::max(1 / ray.direction[axis], -most), most);
            nearSide_[axis] = inverse < 0 ? 1 : 0;
            const float outwards = inverse < 0 ? -slack : slack;
            inverse_[axis] = Lanes(inverse);
            nearOrigin_[axis] = Lanes(ray.origin[axis] + outwards);
            farOrigin_[axis] = Lanes(ray.origin[axis] - outwards);
        }
    }

    // A bit for each child whose box the ray meets at t <= end, and where it enters it.
    std::uint32_t meet(const TreeNode& node, float end, float* entry) const {
        constexpr int width = static_cast<int>(Lanes::size);
        std::uint32_t met = 0;
        for (int first = 0; first < treeWidth; first += width) {
            Lanes enter(0.f), leave(end);
            for (int axis = 0; axis < 3; ++axis) {
                const auto& side = node.side[axis];
                const int near = nearSide_[axis];
                enter = xsimd::max((Lanes::load_aligned(side[near] + first) - nearOrigin_[axis]) * inverse_[axis], enter);
                leave = xsimd::min((Lanes::load_aligned(side[1 - near] + first) - farOrigin_[axis]) * inverse_[axis], leave);
            }
            enter.store_aligned(entry + first);
            met |= core::bitsOf(enter <= leave) << first;
        }
        return met;
    }

private:
    int nearSide_[3];
    Lanes inverse_[3], nearOrigin_[3], farOrigin_[3];
};

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
    if (!at) return false;
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
                if (next.t < t) {
                    std::swap(next.t, t);
                    std::swap(next.reference, at);
                }
                int place = waiting++;
                for (; place > bottom && stack[place - 1].t < next.t; --place) stack[place] = stack[place - 1];
                stack[place] = next;
            }
        }
        if (at.isLeaf() && visit(at.address())) return true;
        do {
            if (waiting == 0) return false;
            at = stack[--waiting].reference;
        } while (stack[waiting].t > nearest);
    }
}

}  // namespace gr
