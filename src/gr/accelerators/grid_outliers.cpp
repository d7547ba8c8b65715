#include "gr/accelerators/grid_outliers.h"

#include <algorithm>
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

constexpr std::size_t mostOutliers = 8;

// Half of it.
double surface(const Bounds& box) {
    const glm::dvec3 size = box.size();
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

// The items that reach farthest to one side, the farthest first: so many that one is left beside all the outliers.
class Outermost {
public:
    Outermost() { farthest_.fill({~0u, -core::infinity}); }

    void offer(std::uint32_t item, float reach) {
        if (!(reach > farthest_.back().reach)) return;
        std::size_t place = farthest_.size() - 1;
        for (; place > 0 && reach > farthest_[place - 1].reach; --place) farthest_[place] = farthest_[place - 1];
        farthest_[place] = {item, reach};
    }

    struct Item {
        std::uint32_t item;
        float reach;
    };
    // Of those that are not taken.
    template<class IsTaken>
    Item first(IsTaken&& isTaken) const {
        return *std::find_if(farthest_.begin(), farthest_.end() - 1, [&](const Item& i) { return !isTaken(i.item); });
    }

private:
    std::array<Item, mostOutliers + 1> farthest_;
};

// What a box of all items, or without some, is made of, so that the items are looked at only once.
class Sides {
public:
    Sides(std::span<const Bounds> bounds, std::span<const std::uint32_t> items) {
        for (const std::uint32_t item : items)
            for (int axis = 0; axis < 3; ++axis) {
                lows_[static_cast<std::size_t>(axis)].offer(item, -bounds[item].low[axis]);
                highs_[static_cast<std::size_t>(axis)].offer(item, bounds[item].high[axis]);
            }
    }

    // The one without which the box is smallest, if that makes it much smaller.
    std::optional<std::uint32_t> findOutlier(std::span<const std::uint32_t> taken) const {
        constexpr double muchSmaller = 0.6;
        const auto isTaken = [&](std::uint32_t item) {
            return std::find(taken.begin(), taken.end(), item) != taken.end();
        };
        double least = muchSmaller * surface(boxWithout(isTaken));
        std::optional<std::uint32_t> outlier;
        for (const auto* sides : {&lows_, &highs_})
            for (const Outermost& side : *sides) {
                const std::uint32_t item = side.first(isTaken).item;
                const double others =
                    surface(boxWithout([&](std::uint32_t other) { return other == item || isTaken(other); }));
                if (!(others < least)) continue;
                least = others;
                outlier = item;
            }
        return outlier;
    }

private:
    template<class IsTaken>
    Bounds boxWithout(IsTaken&& isTaken) const {
        Bounds box;
        for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] = -lows_[static_cast<std::size_t>(axis)].first(isTaken).reach;
            box.high[axis] = highs_[static_cast<std::size_t>(axis)].first(isTaken).reach;
        }
        return box;
    }

    std::array<Outermost, 3> lows_, highs_;
};

}  // namespace

std::vector<std::uint32_t> takeOutliers(std::span<const Bounds> bounds, std::vector<std::uint32_t>& items) {
    constexpr std::size_t few = 64;
    std::vector<std::uint32_t> outliers;
    if (items.size() <= few) return outliers;
    const Sides sides(bounds, items);
    while (outliers.size() < mostOutliers && items.size() - outliers.size() > few) {
        const std::optional<std::uint32_t> outlier = sides.findOutlier(outliers);
        if (!outlier) break;
        outliers.push_back(*outlier);
    }
    if (!outliers.empty())
        std::erase_if(items, [&](std::uint32_t item) {
            return std::find(outliers.begin(), outliers.end(), item) != outliers.end();
        });
    return outliers;
}

}  // namespace gr
