// Samples counted in cells, and tested against the density that they claim to have.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "support/chi_square.h"
#include "support/quadrature.h"

namespace support {

struct DistributionResult : ChiSquareResult {
    double integral = 0;  // of the pdf over the whole domain
    double missed = 0;  // the share of the draws that gave no sample
};

// What the sphere and the square have in common: a rectangle of cells.
class Histogram {
public:
    // A draw that gave no sample. The pdf then has to integrate to that much less than 1.
    void addMiss() { ++misses_; }

    // Draws so far, with and without a sample.
    double draws() const;

protected:
    struct Range {
        double low, high;
    };

    // The numbers of bins are odd, so that the middle of the domain, where densities like to jump (the horizon), lies
    // within cells: on an edge between them rounding would decide where a sample is counted.
    Histogram(Range x, int columns, Range y, int rows);

    void count(double x, double y);
    void countInvalid() { ++invalid_; }
    DistributionResult testAgainst(const Function2d& density, double level) const;

private:
    double cellIntegral(const Function2d& density, int column, int row, int pieces) const;
    double cellProbability(const Function2d& density, int column, int row) const;

    Range x_, y_;
    int columns_, rows_;
    std::vector<double> counts_;  // row after row
    double misses_ = 0;
    double invalid_ = 0;
};

// Directions, in cells of equal solid angle: cos(theta) in [-1, 1] by phi in [0, 2 pi), about the z axis. By default
// few enough of them for 10^6 samples to show a smooth error of 2 %; a narrow lobe needs more cells.
class SphereHistogram : public Histogram {
public:
    explicit SphereHistogram(int cosThetaBins = 21, int phiBins = 41);

    // A unit vector. Others are counted too, and make the test fail.
    void add(double x, double y, double z);

    // pdfW: of the unit vector (x, y, z), per solid angle.
    using PdfW = std::function<double(double x, double y, double z)>;
    DistributionResult test(const PdfW& pdfW, double level = significance()) const;
};

// Points of the unit square.
class SquareHistogram : public Histogram {
public:
    explicit SquareHistogram(int uBins = 31, int vBins = 31);

    // In [0, 1]. Others are counted too, and make the test fail.
    void add(double u, double v);

    // pdfA: of the point (u, v), per area of the unit square.
    using PdfA = Function2d;
    DistributionResult test(const PdfA& pdfA, double level = significance()) const;
};

}  // namespace support
