// Sorting without branches: a list of pairs to be put in order, the same whatever the numbers are.
#pragma once

#include <vector>

namespace image {

// Afterwards wire `low` has the lesser number and wire `high` the greater one; where only one of the two is looked at
// later on, the other keeps what it had.
struct Exchange {
    int low, high;
    bool needsLow = true, needsHigh = true;
};

struct SortingNetwork {
    std::vector<Exchange> exchanges;
    std::vector<int> order;  // the wires, from that of the least number to that of the greatest

    // Keeps the wires order[first] to order[first + count - 1], and of the exchanges what decides them.
    void keep(std::size_t first, std::size_t count);
};

// K. E. Batcher, "Sorting networks and their applications" (1968), for any number of wires: D. E. Knuth, The Art of
// Computer Programming, volume 3, 5.3.4.

// Sorts the wires 0 to count - 1.
SortingNetwork sortingNetwork(int count);
// Merges the wires 0 to a - 1 with the wires a to a + b - 1. Both are sorted already.
SortingNetwork mergingNetwork(int a, int b);

}  // namespace image
