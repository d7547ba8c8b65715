#include "gr/grid_outliers.h"

#include <array>
#include <optional>

namespace gr {

using core::Bounds;

Bounds boxOf(std::span<const Bounds> bounds, std::span<const std::uint32_t> items) {
    Bounds box;
    for (const std::uint32_t item : items) box.include(bounds[item]);
    return box;
}

namespace {

// Half of it.
double surface(const Bounds& box) {
    const glm::dvec3 size = box.size();
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

// Those that reach farthest to the six sides.
std::array<std::uint32_t, 6> outermost(std::span<const Bounds> bounds, std::span<const std::uint32_t> items) {
    std::array<std::uint32_t, 6> found;
    found.fill(items[0]);
    for (const std::uint32_t item : items)
        for (int axis = 0; axis < 3; ++axis) {
            std::uint32_t& lowest = found[static_cast<std::size_t>(axis)];
            std::uint32_t& highest = found[static_cast<std::size_t>(axis + 3)];
            if (bounds[item].low[axis] < bounds[lowest].low[axis]) lowest = item;
            if (bounds[item].high[axis] > bounds[highest].high[axis]) highest = item;
        }
    return found;
}

// The one without which the box is smallest, if that makes it much smaller.
std::optional<std::uint32_t> findOutlier(std::span<const Bounds> bounds, std::span<const std::uint32_t> items) {
    constexpr double muchSmaller = 0.6;
    double least = muchSmaller * surface(boxOf(bounds, items));
    std::optional<std::uint32_t> outlier;
    for (const std::uint32_t item : outermost(bounds, items)) {
        Bounds others;
        for (const std::uint32_t other : items)
            if (other != item) others.include(bounds[other]);
        if (surface(others) >= least) continue;
        least = surface(others);
        outlier = item;
    }
    return outlier;
}

}  // namespace

std::vector<std::uint32_t> takeOutliers(std::span<const Bounds> bounds, std::vector<std::uint32_t>& items) {
    constexpr std::size_t most = 8, few = 64;
    std::vector<std::uint32_t> outliers;
    while (outliers.size() < most && items.size() > few) {
        const std::optional<std::uint32_t> outlier = findOutlier(bounds, items);
        if (!outlier) break;
        std::erase(items, *outlier);
        outliers.push_back(*outlier);
    }
    return outliers;
}

}  // namespace gr
