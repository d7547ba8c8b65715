// Which of many area lights a surface point asks for light: at random, those more often that by their power, their
// distance and the side to which they shine may bring more. A tree over the lights is walked from its root, at each
// node into the child that promises more, more often. (Conty Estevez and Kulla, "Importance Sampling of Many Lights
// with Adaptive Tree Splitting", 2018; here nothing is split, and the receiving surface's own side does not count.)
#pragma once

#include "gr/light.h"

#include <bit>
#include <vector>

namespace render {

// Lights that lie near each other. Nothing but Reals, so that lanes can gather them.
template<class Real>
struct LightNode {
    core::Vec3<Real> centre;
    Real radius;  // of a ball that holds them
    core::Vec3<Real> axis;
    Real cosine, sine;  // of the half angle of a cone about the axis that holds the normals of all their fronts
    Real power;  // the sum of area times mean radiance, over that of all lights

    // A bound, but for the distance, on the irradiance that they send to a point. Each sends its radiance * area *
    // cosine / distance^2. The cosine is at most that of the angle at the centre, between axis and way, less the cone's
    // half angle, less half of the angle under which the ball is seen.
    Real importance(const core::Vec3<Real>& at) const {
        const core::Vec3<Real> way = at - centre;
        const Real distanceSquared = glm::dot(way, way);
        const Real distance = core::sqrt(distanceSquared);
        const core::Mask<Real> isInside = !(distance > radius);
        const Real ballSine = core::select(isInside, Real(1), radius / distance);
        const Real ballCosine = core::sqrt(core::max(Real(1) - ballSine * ballSine, Real(0)));
        const Real slackCosine = cosine * ballCosine - sine * ballSine;
        const Real slackSine = sine * ballCosine + cosine * ballSine;
        const Real angleCosine = core::select(isInside, Real(1), glm::dot(axis, way) / distance);
        const Real angleSine = core::sqrt(core::max(Real(1) - angleCosine * angleCosine, Real(0)));
        // A negative sine: the slack is more than half a turn.
        const core::Mask<Real> isWithin = isInside | (slackSine < Real(0)) | (angleCosine >= slackCosine);
        const Real bound = core::select(isWithin, Real(1), angleCosine * slackCosine + angleSine * slackSine);
        const Real most = power * core::max(bound, Real(0)) / core::max(distanceSquared, radius * radius);
        return core::min(most, Real(0x1p100f));  // two of them, as a sum, are finite
    }
};

class LightTree {
public:
    // How many lights it can hold: their indices, and those of twice as many nodes, go through lanes as floats.
    static constexpr std::size_t mostLights = 1u << 23;

    LightTree() = default;
    explicit LightTree(const std::vector<gr::AreaLight>& lights);

    // A light's index, and how likely it was: 0 where none can shine at the point, and then any index.
    template<class Real>
    struct Pick {
        Real light, probability;
    };

    // u: uniform in [0, 1).
    template<class Real>
    Pick<Real> pick(const core::Vec3<Real>& at, Real u) const {
        Real node(1), probability(1);
        const Real end(static_cast<float>(nodes_.size()));
        for (int level = 0; level < depth_; ++level) {
            const Real first = node + node;
            const core::Mask<Real> hasChildren = first < end;
            const core::UInt<Real> child = core::toUInt(core::select(hasChildren, first, Real(1)));
            const Real left = importanceOf<Real>(child, at),
                       right = importanceOf<Real>(child + core::UInt<Real>(1), at);
            const Real share = shareOf(left, left + right), otherShare = shareOf(right, left + right);
            const core::Mask<Real> goesLeft = u < share;
            const Real taken = core::select(goesLeft, share, otherShare);
            // Of u, what the choice has not used up.
            const Real rest = core::select(goesLeft, u, u - share) / core::max(taken, Real(0x1p-100f));
            u = core::select(hasChildren, core::min(core::max(rest, Real(0)), Real(1 - 0x1p-24f)), u);
            probability = core::select(hasChildren, probability * taken, probability);
            node = core::select(hasChildren, core::select(goesLeft, first, first + Real(1)), node);
        }
        return {core::gather(lights_.data(), core::toUInt(node)), probability};
    }

    // Of pick(), that it picks this light.
    template<class Real>
    Real probability(const core::Vec3<Real>& at, const Real& light) const {
        Real node = core::gather(leaves_.data(), core::toUInt(light)), probability(1);
        for (int level = 0; level < depth_; ++level) {
            const core::Mask<Real> hasParent = node > Real(1);
            const Real parent = core::wholePart(node * Real(0.5f));
            const Real sibling = parent + parent + (parent + parent + Real(1) - node);
            const auto importance = [&](const Real& n) {
                return importanceOf<Real>(core::toUInt(core::select(hasParent, n, Real(1))), at);
            };
            const Real own = importance(node), other = importance(sibling);
            probability = core::select(hasParent, probability * shareOf(own, own + other), probability);
            node = core::select(hasParent, parent, node);
        }
        return probability;
    }

    std::size_t bytes() const;

private:
    template<class Real>
    Real importanceOf(const core::UInt<Real>& node, const core::Vec3<Real>& at) const {
        using Node = LightNode<float>;
        const core::GatheredRow<Real, Node> row(nodes_.data(), node);
        const LightNode<Real> found{row.vector(offsetof(Node, centre)), row.number(offsetof(Node, radius)),
                                    row.vector(offsetof(Node, axis)),   row.number(offsetof(Node, cosine)),
                                    row.number(offsetof(Node, sine)),   row.number(offsetof(Node, power))};
        return found.importance(at);
    }
    template<class Real>
    static Real shareOf(const Real& part, const Real& all) {
        return core::select(all > Real(0), part / all, Real(0));
    }

    // A node's children are at twice its place, and after that; the root is at 1. With n lights the leaves are from n
    // on.
    std::vector<LightNode<float>> nodes_;
    std::vector<float> lights_;  // at a leaf's place the index of its light
    std::vector<float> leaves_;  // at a light's index the place of its leaf
    int depth_ = 0;
};

}  // namespace render
