// Knuth's 0-1 principle: what sorts all zeros and ones sorts everything.
#include "image/sorting_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace image {
namespace {

std::vector<int> sortedBy(const SortingNetwork& network, std::vector<int> wires) {
    for (const Exchange& exchange : network.exchanges) {
        int& low = wires[static_cast<std::size_t>(exchange.low)];
        int& high = wires[static_cast<std::size_t>(exchange.high)];
        const auto [less, more] = std::minmax({low, high});
        if (exchange.needsLow) low = less;
        if (exchange.needsHigh) high = more;
    }
    std::vector<int> sorted;
    for (const int wire : network.order) sorted.push_back(wires[static_cast<std::size_t>(wire)]);
    return sorted;
}

std::vector<int> zerosAndOnes(int zeros, int ones) {
    std::vector<int> numbers(static_cast<std::size_t>(zeros), 0);
    numbers.insert(numbers.end(), static_cast<std::size_t>(ones), 1);
    return numbers;
}

TEST(SortingNetwork, SortsEveryInput) {
    for (int count = 1; count <= 15; ++count) {
        const SortingNetwork network = sortingNetwork(count);
        for (unsigned bits = 0; bits < 1u << count; ++bits) {
            std::vector<int> numbers;
            for (int i = 0; i < count; ++i) numbers.push_back(int(bits >> i & 1));
            const int ones = std::accumulate(numbers.begin(), numbers.end(), 0);
            ASSERT_EQ(sortedBy(network, numbers), zerosAndOnes(count - ones, ones)) << count << " " << bits;
        }
    }
}

TEST(SortingNetwork, MergesSortedInputs) {
    for (const auto& [a, b] : {std::pair(1, 1), {1, 7}, {7, 1}, {9, 9}, {18, 18}, {46, 30}, {5, 14}, {60, 60}}) {
        const SortingNetwork network = mergingNetwork(a, b);
        for (int onesInA = 0; onesInA <= a; ++onesInA) {
            for (int onesInB = 0; onesInB <= b; ++onesInB) {
                std::vector<int> numbers = zerosAndOnes(a - onesInA, onesInA);
                const std::vector<int> second = zerosAndOnes(b - onesInB, onesInB);
                numbers.insert(numbers.end(), second.begin(), second.end());
                ASSERT_EQ(sortedBy(network, numbers), zerosAndOnes(a + b - onesInA - onesInB, onesInA + onesInB));
            }
        }
    }
}

// As few as the literature has them.
TEST(SortingNetwork, HasBatchersNumberOfExchanges) {
    const int counts[] = {0, 1, 3, 5, 9, 12, 16, 19, 26, 31, 37, 41, 48, 53, 59, 63};  // Knuth, 5.3.4, for 1 to 16
    for (int count = 1; count <= 16; ++count)
        EXPECT_EQ(sortingNetwork(count).exchanges.size(), static_cast<std::size_t>(counts[count - 1])) << count;
}

TEST(SortingNetwork, KeepsWhatIsAskedFor) {
    SortingNetwork network = sortingNetwork(9);
    const std::size_t all = network.exchanges.size();
    network.keep(4, 1);
    EXPECT_LT(network.exchanges.size(), all);
    for (unsigned bits = 0; bits < 1u << 9; ++bits) {
        std::vector<int> numbers;
        for (int i = 0; i < 9; ++i) numbers.push_back(int(bits >> i & 1));
        const int ones = std::accumulate(numbers.begin(), numbers.end(), 0);
        ASSERT_EQ(sortedBy(network, numbers), std::vector<int>{ones > 4});
    }
}

}  // namespace
}  // namespace image
