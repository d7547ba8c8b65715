// Areas without loss are the same by Dekker's products, which floats take, as by fused ones, which lanes take where
// they may.
#include <gtest/gtest.h>

#include <algorithm>

#include "gr/mesh/triangle.h"
#include "lanes/both_widths.h"

namespace lanes {
namespace {

// The sheared corners of triangles, of sizes about two to the powers; many with so few digits that what products lose
// is 0, or so nearly on a line with the ray that what they lose is all.
std::vector<Numbers<6>> corners(int leastPower, int mostPower) {
    Inputs inputs(3);
    return makeInputs<6>(200'000, [&] {
        const int power =
            static_cast<int>(inputs.uniform(static_cast<float>(leastPower), static_cast<float>(mostPower)));
        const bool isCoarse = inputs.chance(0.2);
        Numbers<6> x;
        for (float& number : x) {
            const float digits = inputs.uniform(1, 2) * inputs.oneOf({1, -1});
            number = std::ldexp(isCoarse ? std::round(digits * 4) / 4 : digits, power);
        }
        if (inputs.chance(0.3)) std::copy(&x[0], &x[2], &x[2]);
        if (inputs.chance(0.3)) x[3] = std::nextafter(x[1] * (x[2] / x[0]), inputs.oneOf({1, -1}));
        return x;
    });
}

void expectSameAreas(int leastPower, int mostPower) {
    expectSame(corners(leastPower, mostPower), []<class Real>(const std::array<Real, 6>& x) {
        const Real zero(0), one(1);
        const gr::TriangleRay<Real> along({{zero, zero, zero}, {zero, zero, one}});
        const auto areas = along.exactCross({x[0], x[1], one}, {x[2], x[3], one}, {x[4], x[5], one});
        return std::array<Real, 4>{areas.u, areas.v, areas.w, asNumber<Real>(areas.inside)};
    });
}

TEST(LanesProducts, LoseTheSameAtAllUsualSizes) {
    expectSameAreas(-51, 58);
}

// What tiny products lose, or huge factors, is told by Dekker's alone, and another number by fused ones.
TEST(LanesProducts, LoseTheSameWhereNearlyAllIsLost) {
    expectSameAreas(-75, -52);
}
TEST(LanesProducts, LoseTheSameBeforeInfinity) {
    expectSameAreas(58, 127);
}

}  // namespace
}  // namespace lanes
