#include "support/chi_square.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/test_random.h"

namespace support {
namespace {

using Counts = std::vector<double>;

// Mendel's peas, 1866: the textbooks' example.
TEST(ChiSquareTest, GivesTheTextbookValue) {
    const ChiSquareResult result = chiSquareTest(Counts{315, 108, 101, 32}, Counts{312.75, 104.25, 104.25, 34.75});
    EXPECT_NEAR(result.statistic, 0.470024, 1e-6);
    EXPECT_EQ(result.degreesOfFreedom, 3);
    EXPECT_NEAR(result.pValue, 0.925426, 1e-6);
    EXPECT_TRUE(result.accepted) << result.text;
}

// By rising expectation: {1, 2, 3} expect 6 and are a pool; {4, 4} expect 8; 5 and 20 stand alone.
TEST(ChiSquareTest, PoolsCellsThatExpectTooFew) {
    const ChiSquareResult result = chiSquareTest(Counts{2, 9, 3, 20, 1, 2, 2}, Counts{4, 5, 2, 20, 3, 4, 1});
    EXPECT_EQ(result.degreesOfFreedom, 3);
    EXPECT_DOUBLE_EQ(result.statistic, 0.0 / 6 + 16.0 / 8 + 16.0 / 5 + 0.0 / 20);
}

TEST(ChiSquareTest, AddsAnIncompletePoolToTheLastOne) {
    const ChiSquareResult result = chiSquareTest(Counts{12, 12, 12, 12, 2}, Counts{10, 10, 10, 10, 10}, 15);
    EXPECT_EQ(result.degreesOfFreedom, 1);
    EXPECT_DOUBLE_EQ(result.statistic, 16.0 / 20 + 16.0 / 30);
}

// A test that nothing could fail is no test.
TEST(ChiSquareTest, RejectsASinglePool) {
    EXPECT_FALSE(chiSquareTest(Counts{2, 2}, Counts{2, 2}).accepted);
    EXPECT_FALSE(chiSquareTest(Counts{100, 0}, Counts{100, 0}).accepted);
    EXPECT_FALSE(chiSquareTest({}, {}).accepted);
}

TEST(ChiSquareTest, RejectsSamplesWhereNoneIsExpected) {
    EXPECT_TRUE(chiSquareTest(Counts{500'000, 500'000, 0}, Counts{500'000, 500'000, 0}).accepted);
    const ChiSquareResult result = chiSquareTest(Counts{500'000, 499'999, 1}, Counts{500'000, 500'000, 0});
    EXPECT_FALSE(result.accepted);
    EXPECT_EQ(result.text, "1 samples fell where none is expected");
}

TEST(ChiSquareTest, RejectsExpectationsThatAreNone) {
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {notANumber, infinity, -1.0}) {
        const ChiSquareResult result = chiSquareTest(Counts{50, 50, 0}, Counts{50, 50, bad});
        EXPECT_FALSE(result.accepted) << bad;
        EXPECT_NE(result.text.find("cell 2 expects"), std::string::npos) << result.text;
    }
}

// Every cell fits, but the pdf integrates to 1.002: at this number of samples only the sums can tell.
TEST(ChiSquareTest, RejectsSumsThatDiffer) {
    EXPECT_FALSE(chiSquareTest(Counts{5000, 5000}, Counts{5010, 5010}).accepted);
    EXPECT_TRUE(chiSquareTest(Counts{5000, 5000}, Counts{5004, 5004}).accepted);
    EXPECT_THROW(chiSquareTest(Counts{1, 2}, Counts{3}), std::invalid_argument);
}

// With the right number of degrees of freedom, p-values of true hypotheses are uniform. Two fair dice; the sums 2 and
// 12 expect 10 each and share a pool. One degree too many or too few is rejected: seen by planting it.
TEST(ChiSquareTest, HasUniformPValues) {
    constexpr int repetitions = 2000, throws = 360, intervals = 10;
    Counts expected(11);
    for (int i = 0; i < 11; ++i) expected[i] = throws * (6 - std::abs(i - 5)) / 36.0;
    TestRandom random(1);
    Counts pValues(intervals);
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        Counts observed(11);
        for (int i = 0; i < throws; ++i) {
            const int first = static_cast<int>(6 * random.next());
            const int second = static_cast<int>(6 * random.next());
            ++observed[first + second];
        }
        const ChiSquareResult result = chiSquareTest(observed, expected, 20);
        ASSERT_EQ(result.degreesOfFreedom, 9);
        ++pValues[std::min(intervals - 1, static_cast<int>(intervals * result.pValue))];
    }
    const ChiSquareResult result = chiSquareTest(pValues, Counts(intervals, double(repetitions) / intervals));
    EXPECT_TRUE(result.accepted) << result.text;
}

}  // namespace
}  // namespace support
