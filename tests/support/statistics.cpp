#include "support/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace support {

namespace {

// Both expansions settle after some sqrt(a) terms; the bound only makes sure that they end.
constexpr int mostTerms = 1'000'000;
constexpr double precision = 1e-16;

// P(a, x) without its factor x^a e^-x / Gamma(a): 1/a + x/(a(a+1)) + x^2/(a(a+1)(a+2)) + ...
double lowerSeries(double a, double x) {
    double term = 1 / a;
    double sum = term;
    for (int n = 1; n < mostTerms && term > precision * sum; ++n) {
        term *= x / (a + n);
        sum += term;
    }
    return sum;
}

// Q(a, x) without the same factor: the continued fraction 1/(b0 + c1/(b1 + c2/(b2 + ...))) with b_n = x + 2n + 1 - a
// and c_n = n(a - n), evaluated from the front by the ratios of successive numerators and denominators.
double upperFraction(double a, double x) {
    double b = x + 1 - a;
    double numerators = std::numeric_limits<double>::max();
    double denominators = 1 / b;
    double value = denominators;
    for (int n = 1; n < mostTerms; ++n) {
        const double c = n * (a - n);
        b += 2;
        denominators = 1 / (b + c * denominators);
        numerators = b + c / numerators;
        const double change = numerators * denominators;
        value *= change;
        if (std::abs(change - 1) < 4 * precision) break;
    }
    return value;
}

}  // namespace

double sidak(double alpha, double tests) {
    // 1 - (1 - alpha)^(1/tests) as written would lose all its digits for many tests.
    return -std::expm1(std::log1p(-alpha) / tests);
}

double significance() {
    return sidak(suiteSignificance, statisticalTests);
}

double regularizedGammaQ(double a, double x) {
    if (!(a > 0) || !(x >= 0) || std::isinf(a)) throw std::invalid_argument("regularizedGammaQ: a > 0 and x >= 0");
    if (x == 0) return 1;
    if (std::isinf(x)) return 0;
    const double factor = std::exp(a * std::log(x) - x - std::lgamma(a));
    // Each expansion is quick on its own side of x = a + 1.
    return x < a + 1 ? 1 - factor * lowerSeries(a, x) : factor * upperFraction(a, x);
}

double chiSquarePValue(double statistic, double degreesOfFreedom) {
    return regularizedGammaQ(degreesOfFreedom / 2, statistic / 2);
}

double normalPValue(double z) {
    return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

void RunningMean::add(double value) {
    ++count_;
    const double before = value - mean_;
    mean_ += before / static_cast<double>(count_);
    squaredDeviations_ += before * (value - mean_);
}

double RunningMean::variance() const {
    if (count_ < 2) return std::numeric_limits<double>::quiet_NaN();
    return squaredDeviations_ / static_cast<double>(count_ - 1);
}

double RunningMean::standardError() const {
    return std::sqrt(variance() / static_cast<double>(count_));
}

double zScore(double mean, double standardError, double expected) {
    constexpr double rounding = 1e-6;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!std::isfinite(standardError) || standardError < 0) return infinity;
    if (mean == expected) return 0;
    const double z = (mean - expected) / std::max(standardError, rounding * std::abs(expected));
    return std::isfinite(z) ? z : infinity;
}

TestResult zTest(double mean, double standardError, double expected, double level) {
    TestResult result;
    result.statistic = zScore(mean, standardError, expected);
    result.pValue = normalPValue(result.statistic);
    result.accepted = result.pValue >= level;
    std::ostringstream text;
    text.precision(9);
    text << "mean " << mean << " +- " << standardError << ", expected " << expected << ": z = " << result.statistic
         << ", p = " << result.pValue << (result.accepted ? " >= " : " < ") << level;
    result.text = text.str();
    return result;
}

TestResult zTest(const RunningMean& measured, double expected, double level) {
    return zTest(measured.mean(), measured.standardError(), expected, level);
}

TestResult twoSampleZTest(const RunningMean& a, const RunningMean& b, double level) {
    return zTest(a.mean(), std::hypot(a.standardError(), b.standardError()), b.mean(), level);
}

}  // namespace support
