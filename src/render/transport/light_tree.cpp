#include "render/transport/light_tree.h"

#include "core/bounds.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace render {
namespace {

using core::Vec3f;

using Indices = std::span<std::uint32_t>;

// What the tree knows of a light.
struct Leaf {
    gr::LightBounds bounds;
    double power;
    Vec3f falloff;
    std::size_t group;
};

// Power and falloff are divided by the falloff's number that counts far away: so lights of a group whose powers are
// alike are alike far away.
Leaf leafOf(const auto& light) {
    const Vec3f falloff = light.falloff();
    const int last = falloff.z > 0 ? 2 : falloff.y > 0 ? 1 : 0;
    const double scale = 1 / double{falloff[last]};
    Leaf leaf{light.bounds(), light.power() * scale, Vec3f(0), static_cast<std::size_t>(2 - last)};
    for (int i = 0; i < last; ++i) leaf.falloff[i] = static_cast<float>(std::min(falloff[i] * scale, 1e30));
    leaf.falloff[last] = 1;
    return leaf;
}

std::vector<Leaf> leavesOf(const gr::Lights& lights) {
    std::vector<Leaf> leaves;
    leaves.reserve(lights.placed());
    lights.forEach([&]<class Light>(const Light& light) {
        if constexpr (!Light::isEndless) leaves.push_back(leafOf(light));
    });
    return leaves;
}

// How many leaves are below a node, or are it, where those from `count` to 2 count - 1 are leaves: on each level its
// descendants are a row.
std::size_t leavesBelow(std::size_t node, std::size_t count) {
    std::size_t leaves = 0;
    for (std::size_t first = node, last = node; first < 2 * count; first = 2 * first, last = 2 * last + 1) {
        const std::size_t from = std::max(first, count), to = std::min(last, 2 * count - 1);
        if (from <= to) leaves += to - from + 1;
    }
    return leaves;
}

// The cosine of the angle between an axis and what is farthest from it in a light's cone.
float farthestCosine(const Vec3f& axis, const gr::LightBounds& bounds) {
    const float cosine = glm::dot(axis, bounds.axis), sine = std::sqrt(std::max(0.f, 1 - cosine * cosine));
    const float coneSine = std::sqrt(std::max(0.f, 1 - bounds.cosine * bounds.cosine));
    const bool isBeyondTheBack = sine * bounds.cosine + cosine * coneSine < 0;
    return isBeyondTheBack ? -1 : cosine * bounds.cosine - sine * coneSine;
}

LightNode<float> nodeOf(const std::vector<Leaf>& leaves, Indices below, double allPower) {
    LightNode<float> node{};
    core::Bounds box;
    Vec3f axes(0);
    double power = 0, allRoundPower = 0;
    glm::dvec3 falloff(0);
    for (const std::uint32_t i : below) {
        const Leaf& leaf = leaves[i];
        box.include(leaf.bounds.box);
        axes += leaf.bounds.axis;
        power += leaf.power;
        allRoundPower += leaf.bounds.cosine == -1 ? leaf.power : 0;
        falloff += leaf.power * glm::dvec3(leaf.falloff);
    }
    node.centre = 0.5f * (box.low + box.high);
    // A hair more than the ball and the cone, for rounding.
    node.radius = 0.5f * glm::length(box.size()) * (1 + 0x1p-16f) + 0x1p-20f * box.reach();
    node.axis = glm::length(axes) > 0x1p-10f ? glm::normalize(axes) : leaves[below[0]].bounds.axis;
    float cosine = 1;
    for (const std::uint32_t i : below)
        cosine = std::min(cosine, farthestCosine(node.axis, leaves[i].bounds) - 0x1p-20f);
    node.cosine = std::max(cosine, -1.f);
    node.sine = std::sqrt(1 - node.cosine * node.cosine);
    node.power = allPower > 0 ? static_cast<float>(power / allPower) : 0.f;
    node.falloff = power > 0 ? Vec3f(falloff / power) : leaves[below[0]].falloff;
    // In the middle of a ball full of lights the mean of 1 / distance^2 is 3 / radius^2. Of lamps, which shine to one
    // side, three quarters of it are lost.
    node.least = node.radius / std::sqrt(power > 0 ? 1 + 2 * static_cast<float>(allRoundPower / power) : 1);
    return node;
}

void sortAlongLongestWay(const std::vector<Leaf>& leaves, Indices below) {
    core::Bounds centres;
    for (const std::uint32_t i : below) centres.include(leaves[i].bounds.centre);
    const Vec3f size = centres.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    // Where two lie equally far their order decides, so that every library sorts the same way.
    const auto isBefore = [&](std::uint32_t a, std::uint32_t b) {
        const float atA = leaves[a].bounds.centre[axis], atB = leaves[b].bounds.centre[axis];
        return atA < atB || (atA == atB && a < b);
    };
    std::sort(below.begin(), below.end(), isBefore);
}

}  // namespace

LightTree::LightTree(const gr::Lights& lights)
    : nodes_(2 * lights.placed()), lights_(2 * lights.placed()), leaves_(lights.placed()) {
    const std::vector<Leaf> leaves = leavesOf(lights);
    const double allPower = std::transform_reduce(leaves.begin(), leaves.end(), 0., std::plus<>(),
                                                  [](const Leaf& leaf) { return leaf.power; });
    std::size_t base = 0;
    for (std::size_t group = 0; group < mostGroups; ++group) {
        std::vector<std::uint32_t> order;
        for (std::uint32_t i = 0; i < leaves.size(); ++i)
            if (leaves[i].group == group) order.push_back(i);
        const std::size_t count = order.size();
        if (count == 0) continue;
        const auto build = [&](const auto& self, std::size_t node, Indices below) -> void {
            nodes_[base + node] = nodeOf(leaves, below, allPower);
            if (node >= count) {
                lights_[base + node] = static_cast<float>(below[0]);
                leaves_[below[0]] = static_cast<float>(base + node);
                return;
            }
            // The lights of the two children lie on two sides of a plane.
            sortAlongLongestWay(leaves, below);
            const std::size_t left = leavesBelow(2 * node, count);
            self(self, 2 * node, below.first(left));
            self(self, 2 * node + 1, below.subspan(left));
        };
        build(build, 1, order);
        groups_.push_back({static_cast<float>(base), static_cast<float>(2 * count)});
        depth_ = std::max(depth_, static_cast<int>(std::bit_width(2 * count - 1)) - 1);
        base += 2 * count;
    }
    allAreAsLamps_ = std::all_of(nodes_.begin(), nodes_.end(), [](const LightNode<float>& node) {
        return node.power == 0 || (node.falloff == Vec3f(0, 0, 1) && node.least == node.radius);
    });
}

std::size_t LightTree::bytes() const {
    return nodes_.capacity() * sizeof(nodes_[0]) + (lights_.capacity() + leaves_.capacity()) * sizeof(float);
}

}  // namespace render
