#include "render/light_tree.h"

#include "core/bounds.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace render {
namespace {

using core::Vec3f;

using Indices = std::span<std::uint32_t>;

double powerOf(const gr::AreaLight& light) {
    return double{light.area} * (double{light.radiance.x} + light.radiance.y + light.radiance.z) / 3;
}

Vec3f centreOf(const gr::AreaLight& light) {
    return light.corner + 0.5f * (light.edge1 + light.edge2);
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

LightNode<float> nodeOf(const std::vector<gr::AreaLight>& lights, Indices below, double allPower) {
    LightNode<float> node{};
    core::Bounds bounds;
    Vec3f normals(0);
    double power = 0;
    for (const std::uint32_t i : below) {
        const gr::AreaLight& light = lights[i];
        for (const float u : {0.f, 1.f})
            for (const float v : {0.f, 1.f}) bounds.include(light.corner + light.edge1 * u + light.edge2 * v);
        normals += light.normal;
        power += powerOf(light);
    }
    node.centre = 0.5f * (bounds.low + bounds.high);
    // A hair more than the ball and the cone, for rounding.
    node.radius = 0.5f * glm::length(bounds.size()) * (1 + 0x1p-16f) + 0x1p-20f * bounds.reach();
    node.axis = glm::length(normals) > 0x1p-10f ? glm::normalize(normals) : lights[below[0]].normal;
    float cosine = 1;
    for (const std::uint32_t i : below) cosine = std::min(cosine, glm::dot(node.axis, lights[i].normal) - 0x1p-20f);
    node.cosine = std::max(cosine, -1.f);
    node.sine = std::sqrt(1 - node.cosine * node.cosine);
    node.power = allPower > 0 ? static_cast<float>(power / allPower) : 0.f;
    return node;
}

void sortAlongLongestWay(const std::vector<gr::AreaLight>& lights, Indices below) {
    core::Bounds centres;
    for (const std::uint32_t i : below) centres.include(centreOf(lights[i]));
    const Vec3f size = centres.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    // Where two lie equally far their order decides, so that every library sorts the same way.
    const auto isBefore = [&](std::uint32_t a, std::uint32_t b) {
        const float atA = centreOf(lights[a])[axis], atB = centreOf(lights[b])[axis];
        return atA < atB || (atA == atB && a < b);
    };
    std::sort(below.begin(), below.end(), isBefore);
}

}  // namespace

LightTree::LightTree(const std::vector<gr::AreaLight>& lights)
    : nodes_(2 * lights.size()), lights_(2 * lights.size()), leaves_(lights.size()) {
    const std::size_t count = lights.size();
    if (count == 0) return;
    depth_ = std::bit_width(2 * count - 1) - 1;
    const double allPower = std::transform_reduce(lights.begin(), lights.end(), 0., std::plus<>(), powerOf);
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    const auto build = [&](const auto& self, std::size_t node, Indices below) -> void {
        nodes_[node] = nodeOf(lights, below, allPower);
        if (node >= count) {
            lights_[node] = static_cast<float>(below[0]);
            leaves_[below[0]] = static_cast<float>(node);
            return;
        }
        // The lights of the two children lie on two sides of a plane.
        sortAlongLongestWay(lights, below);
        const std::size_t left = leavesBelow(2 * node, count);
        self(self, 2 * node, below.first(left));
        self(self, 2 * node + 1, below.subspan(left));
    };
    build(build, 1, order);
}

std::size_t LightTree::bytes() const {
    return nodes_.capacity() * sizeof(nodes_[0]) + (lights_.capacity() + leaves_.capacity()) * sizeof(float);
}

}  // namespace render
