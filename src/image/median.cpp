// The windows of neighbouring pixels share most of their columns: each column of n numbers is sorted once, neighbouring
// columns are merged in pairs, those in fours and eights, and a window's median comes out of few such groups. All of it
// is sorting networks, which go over a piece of a line at once, as many pixels as a vector register holds:
//     A. Adams, "Fast median filters using separable sorting networks", ACM Transactions on Graphics 40, 4 (2021)
#include "image/median.h"

#include "core/parallel.h"
#include "image/sorting_network.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace image {
namespace {

// A number for each of a piece's columns, and as many such rows as a network has wires.
template<class Number>
class Rows {
public:
    static constexpr int length = 256 / static_cast<int>(sizeof(Number));  // so that a network's rows stay in the cache

    explicit Rows(std::size_t rows) : numbers_(rows * length) {}
    Number* operator[](int row) { return &numbers_[static_cast<std::size_t>(row) * length]; }

private:
    std::vector<Number> numbers_;
};

template<class Number>
void run(const SortingNetwork& network, Rows<Number>& rows) {
    for (const Exchange& exchange : network.exchanges) {
        Number* __restrict const low = rows[exchange.low];
        Number* __restrict const high = rows[exchange.high];
        if (!exchange.needsHigh) {
            for (int x = 0; x < Rows<Number>::length; ++x) low[x] = std::min(low[x], high[x]);
        } else if (!exchange.needsLow) {
            for (int x = 0; x < Rows<Number>::length; ++x) high[x] = std::max(low[x], high[x]);
        } else {
            for (int x = 0; x < Rows<Number>::length; ++x) {
                const Number less = std::min(low[x], high[x]), more = std::max(low[x], high[x]);
                low[x] = less;
                high[x] = more;
            }
        }
    }
}

// Columns side by side, merged, for each place that they may start at.
struct Group {
    SortingNetwork network;  // of two smaller groups
    int columns;
    int dropped;  // so many of the least numbers are left out: too small to be any window's median

    int kept() const { return static_cast<int>(network.order.size()); }
};

// The networks for a window of n x n.
class MedianNetworks {
public:
    explicit MedianNetworks(int n) : n_(n) {
        groups_.push_back({sortingNetwork(n), 1, 0});
        while (2 * groups_.back().columns <= n) groups_.push_back(merged(groups_.back(), groups_.back()));
        for (Group window = groups_.back(); window.columns < n; window = joins_.back())
            joins_.push_back(merged(window, groups_[nextGroup(window.columns)]));
    }

    const std::vector<Group>& groups() const { return groups_; }  // of 1, 2, 4, ... columns
    const std::vector<Group>& joins() const { return joins_; }  // what makes a window of the largest group
    // The largest group that a window of so many columns still has room for.
    std::size_t nextGroup(int columns) const {
        return static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(n_ - columns)) - 1);
    }
    // Rows that are enough for the largest network.
    std::size_t rows() const {
        std::size_t most = static_cast<std::size_t>(n_);
        for (std::size_t i = 1; i < groups_.size(); ++i)
            most = std::max(most, 2 * static_cast<std::size_t>(groups_[i - 1].kept()));
        return 2 * most;
    }

private:
    // A number with half of the window on one side of it cannot be the median, nor can those beyond.
    Group merged(const Group& a, const Group& b) const {
        Group group{mergingNetwork(a.kept(), b.kept()), a.columns + b.columns, a.dropped + b.dropped};
        const int all = group.columns * n_, half = (n_ * n_ + 1) / 2;
        const int first = std::max(all - half, group.dropped);
        const int end = std::min(half, group.dropped + group.kept());
        group.network.keep(static_cast<std::size_t>(first - group.dropped), static_cast<std::size_t>(end - first));
        group.dropped = first;
        return group;
    }

    int n_;
    std::vector<Group> groups_, joins_;
};

// Medians of whole windows, a piece of a line after another.
template<class Number>
class LineFilter {
public:
    LineFilter(const MedianNetworks& networks, int n) : networks_(networks), n_(n), work_(networks.rows()) {
        for (const Group& group : networks.groups()) sorted_.emplace_back(static_cast<std::size_t>(group.kept()));
    }

    // How many medians a piece gives.
    int pieceLength() const { return Rows<Number>::length - (n_ - 1); }

    // window: the first window's corner. columns: how many there are from it on.
    void filter(const Number* window, std::size_t width, int columns, Number* medians) {
        for (int y = 0; y < n_; ++y)
            std::memcpy(work_[y], window + static_cast<std::size_t>(y) * width, bytes(columns));
        run(networks_.groups()[0].network, work_);
        store(networks_.groups()[0], sorted_[0]);
        for (std::size_t i = 1; i < sorted_.size(); ++i) {
            load(networks_.groups()[i - 1], i - 1, 0, 0);
            load(networks_.groups()[i - 1], i - 1, networks_.groups()[i - 1].kept(), networks_.groups()[i - 1].columns);
            run(networks_.groups()[i].network, work_);
            store(networks_.groups()[i], sorted_[i]);
        }
        join();
        std::memcpy(medians, work_[0], bytes(columns - (n_ - 1)));
    }

private:
    static std::size_t bytes(int count) { return static_cast<std::size_t>(count) * sizeof(Number); }

    void store(const Group& group, Rows<Number>& to) {
        for (int i = 0; i < group.kept(); ++i)
            std::memcpy(to[i], work_[group.network.order[static_cast<std::size_t>(i)]], bytes(Rows<Number>::length));
    }
    // row: where to. column: the group's first, counted from each window's.
    void load(const Group& group, std::size_t number, int row, int column) {
        for (int i = 0; i < group.kept(); ++i)
            std::memcpy(work_[row + i], sorted_[number][i] + column, bytes(Rows<Number>::length - column));
    }

    // Merges the largest group in its place with what is right of it. The median is in row 0 then.
    void join() {
        const std::vector<Group>& groups = networks_.groups();
        load(groups.back(), groups.size() - 1, 0, 0);
        const Group* window = &groups.back();
        for (const Group& joined : networks_.joins()) {
            const std::size_t next = networks_.nextGroup(window->columns);
            load(groups[next], next, window->kept(), window->columns);
            run(joined.network, work_);
            compact(joined);
            window = &joined;
        }
    }

    // Puts what is kept into the first rows, in order.
    void compact(const Group& group) {
        Rows<Number>& spare = sorted_.back();
        for (int i = 0; i < group.kept(); ++i)
            std::memcpy(spare[i], work_[group.network.order[static_cast<std::size_t>(i)]], bytes(Rows<Number>::length));
        for (int i = 0; i < group.kept(); ++i) std::memcpy(work_[i], spare[i], bytes(Rows<Number>::length));
    }

    const MedianNetworks& networks_;
    int n_;
    Rows<Number> work_;
    std::vector<Rows<Number>> sorted_;  // the groups' numbers, from the least
};

// Floats as whole numbers in the same order, so that there is an order for NaN, too.
std::int32_t keyOf(float x) {
    const auto bits = std::bit_cast<std::int32_t>(std::isnan(x) ? std::abs(x) : x);
    return bits < 0 ? bits ^ 0x7FFFFFFF : bits;
}
float numberOf(std::int32_t key) {
    return std::bit_cast<float>(key < 0 ? key ^ 0x7FFFFFFF : key);
}

std::uint8_t middle(std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>((a + b + 1) / 2);
}
std::uint16_t middle(std::uint16_t a, std::uint16_t b) {
    return static_cast<std::uint16_t>((a + b + 1) / 2);
}
std::int32_t middle(std::int32_t a, std::int32_t b) {
    return keyOf(static_cast<float>((static_cast<double>(numberOf(a)) + static_cast<double>(numberOf(b))) / 2));
}

template<class Number>
struct Plane {
    const Number* numbers;
    int width, height;

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }

    // The plain way, for windows that an edge cuts.
    Number median(int x, int y, int reach) const {
        Number window[largestMedian * largestMedian]{};
        Number* end = window;
        for (int row = std::max(y - reach, 0); row <= std::min(y + reach, height - 1); ++row)
            for (int column = std::max(x - reach, 0); column <= std::min(x + reach, width - 1); ++column)
                *end++ = numbers[at(column, row)];
        Number* const upper = window + (end - window) / 2;
        std::nth_element(window, upper, end);
        return (end - window) % 2 == 1 ? *upper : middle(*std::max_element(window, upper), *upper);
    }
};

template<class Number>
void filterLine(const Plane<Number>& plane, int y, int n, LineFilter<Number>& filter, Number* medians) {
    const int reach = n / 2, inner = std::max(plane.width - 2 * reach, 0);
    const bool isWhole = y >= reach && y + reach < plane.height;
    for (int x = 0; isWhole && x < inner; x += filter.pieceLength()) {
        const int count = std::min(filter.pieceLength(), inner - x);
        filter.filter(plane.numbers + plane.at(x, y - reach), static_cast<std::size_t>(plane.width), count + n - 1,
                      medians + reach + x);
    }
    for (int x = 0; x < plane.width; ++x) {
        if (isWhole && inner > 0 && x == reach) x += inner;
        if (x < plane.width) medians[x] = plane.median(x, y, reach);
    }
}

template<class Number>
std::vector<Number> filterPlane(std::span<const Number> numbers, int width, int height, int n, int threads) {
    const MedianNetworks networks(n);
    const Plane<Number> plane{numbers.data(), width, height};
    std::vector<Number> medians(numbers.size());
    constexpr int linesPerTask = 16;
    core::parallelFor((height + linesPerTask - 1) / linesPerTask, core::threadCount(threads), [&](int task) {
        LineFilter<Number> filter(networks, n);
        for (int y = task * linesPerTask; y < std::min((task + 1) * linesPerTask, height); ++y)
            filterLine(plane, y, n, filter, &medians[plane.at(0, y)]);
    });
    return medians;
}

}  // namespace

template<class Number>
std::vector<Number> medianFilter(std::span<const Number> numbers, int width, int height, int n, int threads) {
    if constexpr (!std::is_same_v<Number, float>) {
        return filterPlane(numbers, width, height, n, threads);
    } else {
        std::vector<std::int32_t> keys(numbers.size());
        std::transform(numbers.begin(), numbers.end(), keys.begin(), keyOf);
        keys = filterPlane<std::int32_t>(keys, width, height, n, threads);
        std::vector<float> medians(numbers.size());
        std::transform(keys.begin(), keys.end(), medians.begin(), numberOf);
        return medians;
    }
}

template std::vector<std::uint8_t> medianFilter(std::span<const std::uint8_t>, int, int, int, int);
template std::vector<std::uint16_t> medianFilter(std::span<const std::uint16_t>, int, int, int, int);
template std::vector<float> medianFilter(std::span<const float>, int, int, int, int);

void applyMedian(Image& image, int n) {
    for (ImageChannel& channel : image.channels) {
        const auto filter = [&]<class Number>(std::vector<Number>& numbers) {
            numbers = medianFilter<Number>(numbers, image.held.width, image.held.height, n);
        };
        std::visit(filter, channel.samples);
    }
}

}  // namespace image
