// What is shown of a radiance. The curve of sRGB is in srgb_test.cpp.
// Seen to fail with a radiance that counts once, a white half as bright, half of the toe, and the curve of sRGB left
// out behind it or put behind the linear one.
#include "image/curve.h"

#include "core/srgb.h"

#include <gtest/gtest.h>

#include <limits>

namespace image {
namespace {

// Worked out by hand from the six constants, as fractions: h(0.36) = 0.04144/0.25944 - 1/15, h(2) = 0.704/1.66 - 1/15,
// h(11.2) = 19.38/24.476 - 1/15.
TEST(FilmicCurve, HasTheValuesOfItsFormula) {
    const double white = 19.38 / 24.476 - 1 / 15.;
    EXPECT_NEAR(filmic(0.18), (0.04144 / 0.25944 - 1 / 15.) / white, 1e-12);
    EXPECT_NEAR(filmic(1), (0.704 / 1.66 - 1 / 15.) / white, 1e-12);
    EXPECT_NEAR(filmic(0.18), 0.12834, 5e-6);
    EXPECT_NEAR(filmic(1), 0.49292, 5e-6);
    EXPECT_NEAR(filmic(1e-7) / 1e-7, 0.76615, 5e-6) << "the slope at 0";
}

TEST(FilmicCurve, GoesFromBlackToWhite) {
    EXPECT_EQ(filmic(0), 0);
    EXPECT_EQ(filmic(-1), 0);
    EXPECT_EQ(filmic(5.6), 1);
    EXPECT_EQ(filmic(1e30), 1);
    EXPECT_EQ(filmic(std::numeric_limits<double>::infinity()), 1);
    EXPECT_LT(filmic(5.59), 1);
}

TEST(FilmicCurve, RisesEverywhere) {
    double before = 0;
    for (double x = 1e-6; x < 5.6; x *= 1.001) {
        const double now = filmic(x);
        ASSERT_GT(now, before) << x;
        before = now;
    }
}

TEST(Curve, MakesBytes) {
    for (const float x : {-1.f, 0.f, 0.1f, 0.5f, 1.f, 3.f, 1e30f}) {
        const double cut = std::min(std::max(static_cast<double>(x), 0.), 1.);
        EXPECT_EQ(toByte(Curve::linear, x), static_cast<int>(cut * 255 + 0.5)) << x;
        EXPECT_EQ(toByte(Curve::srgb, x), static_cast<int>(core::encodeSrgb(cut) * 255 + 0.5)) << x;
        EXPECT_EQ(toByte(Curve::filmic, x), static_cast<int>(core::encodeSrgb(filmic(x)) * 255 + 0.5)) << x;
    }
}

TEST(Curve, HasANameInItsPlace) {
    EXPECT_EQ(curveNamed("srgb"), Curve::srgb);
    EXPECT_EQ(curveNamed("linear"), Curve::linear);
    EXPECT_EQ(curveNamed("filmic"), Curve::filmic);
    EXPECT_EQ(curveNames().size(), 3u);
}

}  // namespace
}  // namespace image
