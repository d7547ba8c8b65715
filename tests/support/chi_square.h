// Pearson's chi-squared test: whether samples fall into cells as often as they should.
#pragma once

#include <span>

#include "support/statistics.h"

namespace support {

struct ChiSquareResult : TestResult {
    int degreesOfFreedom = 0;
};

// observed: how many samples fell in each cell; expected: how many should, on average, the cells covering everything
// that can happen. Cells that expect fewer than minimumExpected are pooled until they expect as many, since the
// statistic follows its distribution only then. Rejected outright: an expectation that is negative or not finite,
// a sample where none is expected, sums that differ by more than 1 in 1000, and too few samples for two pools.
ChiSquareResult chiSquareTest(std::span<const double> observed, std::span<const double> expected,
                              double minimumExpected = 5, double level = significance());

}  // namespace support
