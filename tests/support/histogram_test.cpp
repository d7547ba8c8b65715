#include "support/histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/test_random.h"

namespace support {
namespace {

using std::numbers::pi;
constexpr int samples = 1'000'000;

void addDirection(SphereHistogram& histogram, double cosTheta, double phi) {
    const double sinTheta = std::sqrt(1 - cosTheta * cosTheta);
    histogram.add(sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta);
}

SphereHistogram cosineSamples(SphereHistogram histogram = SphereHistogram()) {
    TestRandom random(2);
    for (int i = 0; i < samples; ++i) {
        const double cosTheta = std::sqrt(1 - random.next());
        addDirection(histogram, cosTheta, 2 * pi * random.next());
    }
    return histogram;
}

double cosinePdfW(double, double, double z) {
    return std::max(0.0, z) / pi;
}

double uniformPdfW(double, double, double z) {
    return z > 0 ? 1 / (2 * pi) : 0;
}

TEST(SphereHistogram, AcceptsACorrectSampler) {
    const DistributionResult result = cosineSamples().test(cosinePdfW);
    EXPECT_TRUE(result.accepted) << result.text;
    EXPECT_NEAR(result.integral, 1, 1e-6);
    EXPECT_EQ(result.missed, 0);
    EXPECT_GT(result.degreesOfFreedom, 400);
    const DistributionResult fine = cosineSamples(SphereHistogram(51, 101)).test(cosinePdfW);
    EXPECT_TRUE(fine.accepted) << fine.text;
}

// Wrong by 2 % (root mean square) while it still integrates to 1, so that only its shape can tell; in theta and in phi.
TEST(SphereHistogram, RejectsAPdfOfSlightlyWrongShape) {
    const SphereHistogram histogram = cosineSamples();
    const auto wrongInPhi = [](double x, double y, double z) {
        const double sinTheta = std::hypot(x, y);
        return cosinePdfW(x, y, z) * (1 + 0.02 * std::numbers::sqrt2 * (sinTheta > 0 ? x / sinTheta : 0));
    };
    const DistributionResult inPhi = histogram.test(wrongInPhi);
    EXPECT_NEAR(inPhi.integral, 1, 1e-6);
    EXPECT_FALSE(inPhi.accepted) << inPhi.text;
    // z^2 is uniform in [0, 1] for these samples.
    const auto wrongInTheta = [](double x, double y, double z) {
        return cosinePdfW(x, y, z) * (1 + 0.02 * std::sqrt(12.0) * (z * z - 0.5));
    };
    const DistributionResult inTheta = histogram.test(wrongInTheta);
    EXPECT_NEAR(inTheta.integral, 1, 1e-6);
    EXPECT_FALSE(inTheta.accepted) << inTheta.text;
}

TEST(SphereHistogram, RejectsAPdfThatIsTooLarge) {
    const auto tooLarge = [](double x, double y, double z) { return 1.02 * cosinePdfW(x, y, z); };
    const DistributionResult result = cosineSamples().test(tooLarge);
    EXPECT_NEAR(result.integral, 1.02, 1e-6);
    EXPECT_FALSE(result.accepted) << result.text;
}

// Either the sampler or the pdf forgets it: both directions of the fault.
TEST(SphereHistogram, RejectsADroppedCosine) {
    EXPECT_FALSE(cosineSamples().test(uniformPdfW).accepted);
    SphereHistogram uniform;
    TestRandom random(3);
    for (int i = 0; i < samples; ++i) {
        const double cosTheta = 1 - random.next();
        addDirection(uniform, cosTheta, 2 * pi * random.next());
    }
    const DistributionResult result = uniform.test(uniformPdfW);
    EXPECT_TRUE(result.accepted) << result.text;
    EXPECT_FALSE(uniform.test(cosinePdfW).accepted);
}

TEST(SphereHistogram, RejectsOneSampleBelowTheHorizon) {
    SphereHistogram histogram = cosineSamples();
    histogram.add(0, 0.6, -0.8);
    EXPECT_FALSE(histogram.test(cosinePdfW).accepted);
}

TEST(SphereHistogram, RejectsWhatIsNoDirection) {
    SphereHistogram tooLong = cosineSamples(), notANumber = tooLong;
    tooLong.add(0, 0, 1.01);
    EXPECT_FALSE(tooLong.test(cosinePdfW).accepted);
    notANumber.add(std::numeric_limits<double>::quiet_NaN(), 0, 1);
    EXPECT_FALSE(notANumber.test(cosinePdfW).accepted);
    EXPECT_EQ(notANumber.draws(), samples + 1);
}

TEST(SphereHistogram, RejectsAPdfThatIsNotANumber) {
    const auto broken = [](double x, double y, double z) { return z > 0.9 ? std::sqrt(-z) : cosinePdfW(x, y, z); };
    EXPECT_FALSE(cosineSamples().test(broken).accepted);
}

// The cap reaches into its lowest row of cells by a hundredth of their height: between the points of the quadrature.
TEST(SphereHistogram, FindsAPdfInTheCornerOfACell) {
    SphereHistogram histogram;
    const double lowest = 1 - 2.0 / 21 * 3.01;
    TestRandom random(4);
    for (int i = 0; i < samples; ++i) {
        const double cosTheta = lowest + (1 - lowest) * random.next();
        addDirection(histogram, cosTheta, 2 * pi * random.next());
    }
    const auto pdfW = [lowest](double, double, double z) { return z >= lowest ? 1 / (2 * pi * (1 - lowest)) : 0; };
    const DistributionResult result = histogram.test(pdfW);
    EXPECT_TRUE(result.accepted) << result.text;
}

// A fifth of the draws gives nothing: the pdf integrates to 0.8, and one that claims 1 or 0.81 is rejected.
TEST(SphereHistogram, CountsDrawsWithoutASample) {
    SphereHistogram histogram;
    TestRandom random(5);
    for (int i = 0; i < samples; ++i) {
        const bool missed = random.next() < 0.2;
        const double cosTheta = std::sqrt(1 - random.next());
        const double phi = 2 * pi * random.next();
        if (missed)
            histogram.addMiss();
        else
            addDirection(histogram, cosTheta, phi);
    }
    const auto scaled = [](double factor) {
        return [factor](double x, double y, double z) { return factor * cosinePdfW(x, y, z); };
    };
    const DistributionResult result = histogram.test(scaled(0.8));
    EXPECT_TRUE(result.accepted) << result.text;
    EXPECT_NEAR(result.integral, 0.8, 1e-6);
    EXPECT_NEAR(result.integral + result.missed, 1, 2e-3);
    EXPECT_FALSE(histogram.test(scaled(1)).accepted);
    EXPECT_FALSE(histogram.test(scaled(0.81)).accepted);
}

// A twentieth of a per cent: too little for the sum of the expected counts to show.
TEST(SphereHistogram, RejectsMissesThatThePdfDenies) {
    SphereHistogram histogram = cosineSamples();
    for (int i = 0; i < samples / 2000; ++i) histogram.addMiss();
    EXPECT_FALSE(histogram.test(cosinePdfW).accepted);
}

// Density 2u: u is the root of a uniform number. Its 2 % (root mean square) is planted along v, and the root is
// dropped.
TEST(SquareHistogram, TellsARightDensityFromAWrongOne) {
    SquareHistogram histogram, rootDropped;
    TestRandom random(6);
    for (int i = 0; i < samples; ++i) {
        const double u = random.next();
        const double v = random.next();
        histogram.add(std::sqrt(u), v);
        rootDropped.add(u, v);
    }
    const auto pdfA = [](double u, double) { return 2 * u; };
    const DistributionResult result = histogram.test(pdfA);
    EXPECT_TRUE(result.accepted) << result.text;
    EXPECT_NEAR(result.integral, 1, 1e-9);
    const auto wrong = [](double u, double v) { return 2 * u * (1 + 0.02 * std::sqrt(12.0) * (v - 0.5)); };
    EXPECT_FALSE(histogram.test(wrong).accepted);
    EXPECT_FALSE(rootDropped.test(pdfA).accepted);
}

TEST(SquareHistogram, RejectsPointsOutside) {
    SquareHistogram histogram(3, 3);
    for (int i = 0; i < 900; ++i) histogram.add((i % 30) / 29.0, (i / 30) / 29.0);
    const auto pdfA = [](double, double) { return 1.0; };
    const DistributionResult result = histogram.test(pdfA);
    EXPECT_TRUE(result.accepted) << "the edges belong to the square: " << result.text;
    histogram.add(1.001, 0.5);
    EXPECT_FALSE(histogram.test(pdfA).accepted);
}

TEST(Histogram, HasAnOddNumberOfBins) {
    EXPECT_THROW(SphereHistogram(20, 41), std::invalid_argument);
    EXPECT_THROW(SphereHistogram(21, 40), std::invalid_argument);
    EXPECT_THROW(SquareHistogram(-1, 3), std::invalid_argument);
}

}  // namespace
}  // namespace support
