#include "support/chi_square.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace support {

namespace {

struct Cell {
    double observed = 0;
    double expected = 0;
};

// Why the counts cannot be tested, or empty.
std::string fault(const std::vector<Cell>& cells) {
    double observed = 0, expected = 0, misplaced = 0;
    std::ostringstream text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Cell& cell = cells[i];
        if (!std::isfinite(cell.expected) || cell.expected < 0) {
            text << "cell " << i << " expects " << cell.expected << " samples";
            return text.str();
        }
        observed += cell.observed;
        expected += cell.expected;
        if (cell.expected == 0) misplaced += cell.observed;
    }
    if (misplaced > 0)
        text << misplaced << " samples fell where none is expected";
    else if (std::abs(expected - observed) > 1e-3 * observed)
        text << "there are " << observed << " samples, but the expected counts sum to " << expected;
    return text.str();
}

// Takes the cells in order of their expectation and closes a pool whenever it expects enough; a cell that expects
// enough is a pool of its own. What was observed has no say, or the test would be biased.
std::vector<Cell> pooled(std::vector<Cell> cells, double minimumExpected) {
    std::stable_sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.expected < b.expected; });
    std::vector<Cell> pools;
    Cell open;
    for (const Cell& cell : cells) {
        open.observed += cell.observed;
        open.expected += cell.expected;
        if (open.expected < minimumExpected) continue;
        pools.push_back(open);
        open = {};
    }
    if (!pools.empty()) {
        pools.back().observed += open.observed;
        pools.back().expected += open.expected;
    }
    return pools;
}

}  // namespace

ChiSquareResult chiSquareTest(std::span<const double> observed, std::span<const double> expected,
                              double minimumExpected, double level) {
    if (observed.size() != expected.size()) throw std::invalid_argument("chiSquareTest: as many counts as expected");
    std::vector<Cell> cells(observed.size());
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = {observed[i], expected[i]};

    ChiSquareResult result;
    result.text = fault(cells);
    if (!result.text.empty()) return result;
    const std::vector<Cell> pools = pooled(std::move(cells), minimumExpected);
    if (pools.size() < 2) {
        result.text = "too few samples, or all in one cell: there is nothing to test";
        return result;
    }

    for (const Cell& pool : pools) {
        const double difference = pool.observed - pool.expected;
        result.statistic += difference * difference / pool.expected;
    }
    result.degreesOfFreedom = static_cast<int>(pools.size()) - 1;
    result.pValue = chiSquarePValue(result.statistic, result.degreesOfFreedom);
    result.accepted = result.pValue >= level;
    std::ostringstream text;
    text << "chi-squared = " << result.statistic << " with " << result.degreesOfFreedom
         << " degrees of freedom: p = " << result.pValue << (result.accepted ? " >= " : " < ") << level;
    result.text = text.str();
    return result;
}

}  // namespace support
