#include "support/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace support {
namespace {

using std::numbers::pi;

TEST(Integrate, AgreesWithClosedForms) {
    EXPECT_NEAR(integrate([](double x) { return std::sin(x); }, 0, pi, 1e-12), 2, 1e-13);
    EXPECT_NEAR(integrate([](double x) { return std::exp(-x * x); }, -10, 10, 1e-10), std::sqrt(pi), 1e-11);
    EXPECT_NEAR(integrate([](double x) { return 1 / (1 + x * x); }, 0, 1, 1e-12), pi / 4, 1e-13);
    EXPECT_NEAR(integrate([](double x) { return x; }, 1, 0, 1e-12), -0.5, 1e-15);
}

// The seven points are exact to degree 11 at once: a mistyped node or weight is not. No refinement repairs it, as all
// of it is above the tolerance.
TEST(Estimate, IsExactForPolynomialsWithOnePanel) {
    for (int degree = 0; degree <= 11; ++degree) {
        const auto power = [degree](double x) { return std::pow(x, degree); };
        EXPECT_NEAR(estimate(power, -1, 2, 0, 1).value,
                    (std::pow(2, degree + 1) - std::pow(-1, degree + 1)) / (degree + 1), 1e-13 * std::pow(2, degree))
            << degree;
    }
    EXPECT_GT(std::abs(estimate([](double x) { return std::pow(x, 12); }, -1, 1, 0, 1).value - 2.0 / 13), 1e-5);
}

TEST(Integrate, RefinesAtJumpsAndRoots) {
    EXPECT_NEAR(integrate([](double x) { return x < 1.0 / 3 ? 1.0 : 0.0; }, 0, 1, 1e-10), 1.0 / 3, 1e-10);
    EXPECT_NEAR(integrate([](double x) { return std::sqrt(x); }, 0, 1, 1e-10), 2.0 / 3, 1e-10);
    EXPECT_NEAR(integrate([](double x) { return 1 / std::sqrt(x); }, 0, 1, 1e-7), 2, 1e-6);
}

TEST(Integrate, SaysWhenItFails) {
    EXPECT_THROW(integrate([](double x) { return 1 / x; }, 0, 1, 1e-3), std::runtime_error);
    EXPECT_THROW(integrate([](double x) { return std::sin(1e9 * x); }, 0, 1, 1e-3), std::runtime_error);
    EXPECT_THROW(integrate([](double x) { return std::sqrt(x); }, -1, 1, 1e-3), std::runtime_error);
    EXPECT_THROW(integrate2d([](double x, double y) { return 1 / (x + 0 * y); }, -1, 1, 0, 1, 1e-3),
                 std::runtime_error);
}

TEST(Integrate2d, AgreesWithClosedForms) {
    EXPECT_NEAR(integrate2d([](double x, double y) { return x * x * y; }, 0, 3, 1, 2, 1e-12), 9 * 1.5, 1e-12);
    EXPECT_NEAR(integrate2d([](double x, double y) { return std::cos(x) * std::exp(y); }, 0, pi / 2, 0, 1, 1e-11),
                std::numbers::e - 1, 1e-12);
    // Not a product of one function of x and another of y.
    EXPECT_NEAR(integrate2d([](double x, double y) { return 1 / (1 + x + y); }, 0, 1, 0, 1, 1e-12),
                3 * std::log(3.0) - 4 * std::log(2.0), 1e-13);
}

// Jumps along the axes cost few panels, for the direction of each halving is chosen; a slanted one costs many.
TEST(Integrate2d, RefinesAtJumps) {
    const auto corner = [](double x, double y) { return x < 1 / pi && y < 1 / std::numbers::e ? 1.0 : 0.0; };
    EXPECT_NEAR(integrate2d(corner, 0, 1, 0, 1, 1e-4), 1 / (pi * std::numbers::e), 1e-4);
    const auto disc = [](double x, double y) { return x * x + y * y < 1 ? 1.0 : 0.0; };
    EXPECT_NEAR(integrate2d(disc, 0, 1, 0, 1, 1e-3), pi / 4, 1e-4);
}

}  // namespace
}  // namespace support
