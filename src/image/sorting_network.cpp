#include "image/sorting_network.h"

#include <algorithm>
#include <numeric>

namespace image {
namespace {

using Wires = std::vector<int>;

Wires everyOther(const Wires& wires, std::size_t first) {
    Wires half;
    for (std::size_t i = first; i < wires.size(); i += 2) half.push_back(wires[i]);
    return half;
}

// Returns the wires in their new order.
Wires merge(const Wires& a, const Wires& b, std::vector<Exchange>& exchanges) {
    if (a.empty() || b.empty()) return a.empty() ? b : a;
    if (a.size() == 1 && b.size() == 1) {
        exchanges.push_back({a[0], b[0]});
        return {a[0], b[0]};
    }
    // The first, third, ... of both, and the second, fourth, ...: then only neighbours may be in the wrong order.
    const Wires odd = merge(everyOther(a, 0), everyOther(b, 0), exchanges);
    const Wires even = merge(everyOther(a, 1), everyOther(b, 1), exchanges);
    Wires merged{odd[0]};
    for (std::size_t i = 0; i < even.size(); ++i) {
        merged.push_back(even[i]);
        if (i + 1 == odd.size()) continue;
        exchanges.push_back({even[i], odd[i + 1]});
        merged.push_back(odd[i + 1]);
    }
    merged.insert(merged.end(), odd.begin() + static_cast<std::ptrdiff_t>(std::min(even.size() + 1, odd.size())),
                  odd.end());
    return merged;
}

Wires sort(const Wires& wires, std::vector<Exchange>& exchanges) {
    if (wires.size() < 2) return wires;
    const auto middle = wires.begin() + static_cast<std::ptrdiff_t>(wires.size() / 2);
    const Wires low = sort({wires.begin(), middle}, exchanges);
    return merge(low, sort({middle, wires.end()}, exchanges), exchanges);
}

Wires wiresFrom(int first, int count) {
    Wires wires(static_cast<std::size_t>(count));
    std::iota(wires.begin(), wires.end(), first);
    return wires;
}

}  // namespace

void SortingNetwork::keep(std::size_t first, std::size_t count) {
    std::vector<bool> isNeeded(order.size());
    order = Wires(order.begin() + static_cast<std::ptrdiff_t>(first),
                  order.begin() + static_cast<std::ptrdiff_t>(first + count));
    for (const int wire : order) isNeeded[static_cast<std::size_t>(wire)] = true;
    for (auto exchange = exchanges.rbegin(); exchange != exchanges.rend(); ++exchange) {
        const auto low = static_cast<std::size_t>(exchange->low), high = static_cast<std::size_t>(exchange->high);
        exchange->needsLow = isNeeded[low];
        exchange->needsHigh = isNeeded[high];
        isNeeded[low] = isNeeded[high] = exchange->needsLow || exchange->needsHigh;
    }
    std::erase_if(exchanges, [](const Exchange& exchange) { return !exchange.needsLow && !exchange.needsHigh; });
}

SortingNetwork sortingNetwork(int count) {
    SortingNetwork network;
    network.order = sort(wiresFrom(0, count), network.exchanges);
    return network;
}

SortingNetwork mergingNetwork(int a, int b) {
    SortingNetwork network;
    network.order = merge(wiresFrom(0, a), wiresFrom(a, b), network.exchanges);
    return network;
}

}  // namespace image
