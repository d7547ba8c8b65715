#include "support/histogram.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace support {

namespace {

int bin(double value, double low, double high, int bins) {
    const int index = static_cast<int>((value - low) / (high - low) * bins);
    return std::clamp(index, 0, bins - 1);
}

}  // namespace

Histogram::Histogram(Range x, int columns, Range y, int rows) : x_(x), y_(y), columns_(columns), rows_(rows) {
    if (columns < 1 || rows < 1 || columns % 2 == 0 || rows % 2 == 0)
        throw std::invalid_argument("Histogram: the numbers of bins must be odd");
    counts_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
}

double Histogram::draws() const {
    return std::accumulate(counts_.begin(), counts_.end(), misses_ + invalid_);
}

void Histogram::count(double x, double y) {
    const int column = bin(x, x_.low, x_.high, columns_);
    const int row = bin(y, y_.low, y_.high, rows_);
    ++counts_[static_cast<std::size_t>(row * columns_ + column)];
}

double Histogram::cellIntegral(const Function2d& density, int column, int row, int pieces) const {
    // Far below the noise of 10^6 samples. A density in float may be too rough to get there: hence the bound.
    constexpr int mostPanels = 2000;
    const double tolerance = 1e-3 / static_cast<double>(counts_.size()) / (pieces * pieces);
    const double width = (x_.high - x_.low) / columns_ / pieces;
    const double height = (y_.high - y_.low) / rows_ / pieces;
    double sum = 0;
    for (int j = 0; j < pieces; ++j) {
        for (int i = 0; i < pieces; ++i) {
            const double x = x_.low + (column * pieces + i) * width;
            const double y = y_.low + (row * pieces + j) * height;
            sum += estimate2d(density, x, x + width, y, y + height, tolerance, mostPanels).value;
        }
    }
    return sum;
}

double Histogram::cellProbability(const Function2d& density, int column, int row) const {
    const double probability = cellIntegral(density, column, row, 1);
    const bool hasSamples = counts_[static_cast<std::size_t>(row * columns_ + column)] > 0;
    // The density may be positive in a corner between the points of the quadrature: look closer before blaming samples.
    return probability == 0 && hasSamples ? cellIntegral(density, column, row, 16) : probability;
}

DistributionResult Histogram::testAgainst(const Function2d& density, double level) const {
    DistributionResult result;
    const double n = draws();
    result.missed = misses_ / n;
    std::vector<double> observed = counts_, expected;
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            const double probability = cellProbability(density, column, row);
            result.integral += probability;
            expected.push_back(n * probability);
        }
    }
    if (misses_ > 0) {
        observed.push_back(misses_);
        expected.push_back(n * std::max(0.0, 1 - result.integral));
    }

    std::ostringstream text;
    if (invalid_ > 0) {
        text << invalid_ << " of " << n << " samples are outside the domain";
    } else {
        static_cast<ChiSquareResult&>(result) = chiSquareTest(observed, expected, 5, level);
        text << result.text << "; the pdf integrates to " << result.integral << ", " << result.missed
             << " of the draws gave no sample";
    }
    result.text = text.str();
    return result;
}

SphereHistogram::SphereHistogram(int cosThetaBins, int phiBins)
    : Histogram({-1, 1}, cosThetaBins, {0, 2 * std::numbers::pi}, phiBins) {}

void SphereHistogram::add(double x, double y, double z) {
    constexpr double roundingInFloat = 1e-4;
    const double squaredLength = x * x + y * y + z * z;
    // Written so that not a number is invalid too.
    if (!(std::abs(squaredLength - 1) < roundingInFloat)) {
        countInvalid();
        return;
    }
    const double phi = std::atan2(y, x);
    count(z, phi < 0 ? phi + 2 * std::numbers::pi : phi);
}

DistributionResult SphereHistogram::test(const PdfW& pdfW, double level) const {
    // d omega = d cos(theta) d phi: no further factor.
    const auto density = [&pdfW](double cosTheta, double phi) {
        const double sinTheta = std::sqrt(std::max(0.0, 1 - cosTheta * cosTheta));
        return pdfW(sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta);
    };
    return testAgainst(density, level);
}

SquareHistogram::SquareHistogram(int uBins, int vBins) : Histogram({0, 1}, uBins, {0, 1}, vBins) {}

void SquareHistogram::add(double u, double v) {
    if (u >= 0 && u <= 1 && v >= 0 && v <= 1)
        count(u, v);
    else
        countInvalid();
}

DistributionResult SquareHistogram::test(const PdfA& pdfA, double level) const {
    return testAgainst(pdfA, level);
}

}  // namespace support
