// How a test decides that numbers with noise in them are right: p-values, z-tests, and the level they share.
#pragma once

#include <cstddef>
#include <string>

namespace support {

// How many statistical tests the whole suite runs. Raise it when adding tests: a test that runs once per material,
// shape or image counts once for each. Every level below follows from it.
constexpr int statisticalTests = 717;

// The chance that a correct program fails any of those tests.
constexpr double suiteSignificance = 0.01;

// The significance that each of a number of independent tests must have so that, all being true, the chance of one
// or more being rejected is alpha (Sidak's correction).
double sidak(double alpha, double tests);

// The significance of a single test of this suite.
double significance();

// Q(a, x), the regularised upper incomplete gamma function; a > 0, x >= 0.
double regularizedGammaQ(double a, double x);

// The chance that a chi-squared variable is at least this large.
double chiSquarePValue(double statistic, double degreesOfFreedom);

// The chance that a standard normal variable is at least this far from 0, on either side.
double normalPValue(double z);

struct TestResult {
    double statistic = 0;
    double pValue = 0;
    bool accepted = false;
    std::string text;  // for a person: EXPECT_TRUE(result.accepted) << result.text
};

// Mean and variance of what is added, by Welford's recurrence: no cancellation however far the mean is from 0.
class RunningMean {
public:
    void add(double value);

    std::size_t count() const { return count_; }
    double mean() const { return mean_; }
    double variance() const;  // of one value; not a number below two values, so that no test accepts it
    double standardError() const;  // of the mean

private:
    std::size_t count_ = 0;
    double mean_ = 0;
    double squaredDeviations_ = 0;
};

// How many standard errors the mean is from what is expected; infinite where a number is missing or not finite.
// The standard error is taken to be at least 10^-6 of the expected value, which is what rounding in float leaves
// where every sample is the same.
double zScore(double mean, double standardError, double expected);

TestResult zTest(double mean, double standardError, double expected, double level = significance());
TestResult zTest(const RunningMean& measured, double expected, double level = significance());

// Whether two independent estimates have the same mean.
TestResult twoSampleZTest(const RunningMean& a, const RunningMean& b, double level = significance());

}  // namespace support
