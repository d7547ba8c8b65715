// Which of many lights a surface point asks for light: at random, those more often that by their power, their distance
// and the side to which they shine may bring more. A tree over the lights is walked from its root, at each node into
// the child that promises more, more often. (Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive
// Tree Splitting", 2018; here nothing is split, and the receiving surface's own side does not count.)
#pragma once

#include "core/lanes.h"
#include "core/vec.h"
#include "gr/light.h"
#include "render/transport/light_node.h"

#include <array>
#include <cstddef>
#include <vector>

namespace render {

class LightTree {
public:
    // How many lights it can hold: their indices, and those of twice as many nodes, go through lanes as floats.
    static constexpr std::size_t mostLights = 1u << 23;

    LightTree() = default;
    // Of the lights that have a place.
    explicit LightTree(const gr::Lights& lights);

    // A light's index, and how likely it was: 0 where none can shine at the point, and then any index.
    template<class Real>
    struct Pick {
        Real light, probability;
    };

    // u: uniform in [0, 1).
    template<class Real>
    Pick<Real> pick(const core::Vec3<Real>& at, Real u) const {
        const Start<Real> start = pickGroup(at, u);
        Real node(1), probability = start.probability;
        u = start.u;
        for (int level = 0; level < depth_; ++level) {
            const Real first = node + node;
            const core::Mask<Real> hasChildren = first < start.end;
            const core::UInt<Real> child = core::toUInt(core::select(hasChildren, start.base + first, Real(1)));
            const Choice<Real> choice =
                choose(importanceOf<Real>(child, at), importanceOf<Real>(child + core::UInt<Real>(1), at), u);
            u = core::select(hasChildren, choice.u, u);
            probability = core::select(hasChildren, probability * choice.share, probability);
            node = core::select(hasChildren, core::select(choice.isFirst, first, first + Real(1)), node);
        }
        return {core::gather(lights_.data(), core::toUInt(start.base + node)), probability};
    }

    // How likely pick() is to pick this light.
    template<class Real>
    Real probability(const core::Vec3<Real>& at, const Real& light) const {
        const Real leaf = core::gather(leaves_.data(), core::toUInt(light));
        Real base(0), probability = groupProbability(at, leaf, base), node = leaf - base;
        for (int level = 0; level < depth_; ++level) {
            const core::Mask<Real> hasParent = node > Real(1);
            const Real parent = core::wholePart(node * Real(0.5f));
            const Real sibling = parent + parent + (parent + parent + Real(1) - node);
            const auto importance = [&](const Real& n) {
                return importanceOf<Real>(core::toUInt(core::select(hasParent, base + n, Real(1))), at);
            };
            const Real own = importance(node), other = importance(sibling);
            probability = core::select(hasParent, probability * shareOf(own, own + other), probability);
            node = core::select(hasParent, parent, node);
        }
        return probability;
    }

    std::size_t bytes() const;

private:
    // Lights that fade alike far away: with the square of the distance, with the distance, or not. To mix them in a
    // node would tell wrong of either. Each has a tree of its own.
    static constexpr std::size_t mostGroups = 3;
    struct Group {
        float base;  // before its first node
        float end;  // as many nodes
    };

    // One of two, in proportion to what they promise.
    template<class Real>
    struct Choice {
        core::Mask<Real> isFirst;
        Real share;  // of the one that is taken
        Real u;  // what the choice has not used up
    };
    template<class Real>
    static Choice<Real> choose(const Real& first, const Real& second, const Real& u) {
        const Real share = shareOf(first, first + second), otherShare = shareOf(second, first + second);
        const core::Mask<Real> isFirst = u < share;
        const Real taken = core::select(isFirst, share, otherShare);
        const Real rest = core::select(isFirst, u, u - share) / core::max(taken, Real(0x1p-100f));
        return {isFirst, taken, core::min(core::max(rest, Real(0)), Real(1 - 0x1p-24f))};
    }
    template<class Real>
    static Real shareOf(const Real& part, const Real& all) {
        return core::select(all > Real(0), part / all, Real(0));
    }

    // What each group promises, and those behind it.
    template<class Real>
    struct Promises {
        std::array<Real, mostGroups> own, behind;
    };
    template<class Real>
    Promises<Real> promises(const core::Vec3<Real>& at) const {
        Promises<Real> promises;
        Real behind(0);
        for (std::size_t i = groups_.size(); i-- > 0;) {
            promises.behind[i] = behind;
            promises.own[i] = importanceOf<Real>(core::toUInt(Real(groups_[i].base + 1)), at);
            behind += promises.own[i];
        }
        return promises;
    }

    template<class Real>
    struct Start {
        Real base, end, probability, u;
    };
    // One group after the other is taken, or those behind it.
    template<class Real>
    Start<Real> pickGroup(const core::Vec3<Real>& at, const Real& u) const {
        Start<Real> start{Real(groups_.back().base), Real(groups_.back().end), Real(1), u};
        if (groups_.size() == 1) return start;
        const Promises<Real> all = promises(at);
        core::Mask<Real> isOpen = Real(0) < Real(1);
        for (std::size_t i = 0; i + 1 < groups_.size(); ++i) {
            const Choice<Real> choice = choose(all.own[i], all.behind[i], start.u);
            start.u = core::select(isOpen, choice.u, start.u);
            start.probability = core::select(isOpen, start.probability * choice.share, start.probability);
            const core::Mask<Real> isTaken = isOpen & choice.isFirst;
            start.base = core::select(isTaken, Real(groups_[i].base), start.base);
            start.end = core::select(isTaken, Real(groups_[i].end), start.end);
            isOpen = isOpen & !choice.isFirst;
        }
        return start;
    }
    // How likely pickGroup() is to pick the group in which the leaf is. base: becomes that group's.
    template<class Real>
    Real groupProbability(const core::Vec3<Real>& at, const Real& leaf, Real& base) const {
        Real probability(1);
        base = Real(groups_.back().base);
        if (groups_.size() == 1) return probability;
        const Promises<Real> all = promises(at);
        for (std::size_t i = groups_.size() - 1; i-- > 0;) {
            const Real sum = all.own[i] + all.behind[i];
            const core::Mask<Real> isHere = leaf < Real(groups_[i].base + groups_[i].end);
            probability = core::select(isHere, shareOf(all.own[i], sum), probability * shareOf(all.behind[i], sum));
            base = core::select(isHere, Real(groups_[i].base), base);
        }
        return probability;
    }

    template<class Real>
    Real importanceOf(const core::UInt<Real>& node, const core::Vec3<Real>& at) const {
        using Node = LightNode<float>;
        const core::GatheredRow<Real, Node> row(nodes_.data(), node);
        LightNode<Real> found{row.vector(offsetof(Node, centre)), row.number(offsetof(Node, radius)),
                              row.vector(offsetof(Node, axis)),   row.number(offsetof(Node, cosine)),
                              row.number(offsetof(Node, sine)),   row.number(offsetof(Node, power)),
                              {Real(0), Real(0), Real(1)},        row.number(offsetof(Node, radius))};
        if (!allAreAsLamps_) {
            found.falloff = row.vector(offsetof(Node, falloff));
            found.least = row.number(offsetof(Node, least));
        }
        return found.importance(at);
    }

    // Group after group. In a group, a node's children are at twice its place, and after that; the root is at 1. With n
    // lights the leaves are from n on.
    std::vector<LightNode<float>> nodes_;
    std::vector<float> lights_;  // at a leaf's place the index of its light
    std::vector<float> leaves_;  // at a light's index the place of its leaf
    std::vector<Group> groups_;  // those that have lights
    bool allAreAsLamps_ = true;  // nodes' falloff is {0, 0, 1} and their least distance the radius
    int depth_ = 0;  // of the deepest
};

}  // namespace render
