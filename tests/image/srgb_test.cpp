// From radiance to the 8 bits of a file.
#include "image/image_file.h"

#include <gtest/gtest.h>

#include <cmath>

namespace image {
namespace {

// The radiance that a display shows for a code between 0 and 255, by the standard's other formula, from code to light.
double shown(double code) {
    const double encoded = code / 255;
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// A code begins half way from the one before it. Seen to fail with a rounding down, a power of 2.2, and 256 for 255.
TEST(Srgb, ChangesItsCodeAtEachOf255Thresholds) {
    for (int code = 0; code < 255; ++code) {
        const double threshold = shown(code + 0.5);
        EXPECT_EQ(toByte(Curve::srgb, static_cast<float>(threshold * (1 - 1e-6))), code);
        EXPECT_EQ(toByte(Curve::srgb, static_cast<float>(threshold * (1 + 1e-6))), code + 1);
    }
}

TEST(Srgb, ComesBackToEveryCode) {
    for (int code = 0; code < 256; ++code) EXPECT_EQ(toByte(Curve::srgb, static_cast<float>(shown(code))), code);
}

// Numbers that others publish.
TEST(Srgb, KnowsTheUsualGreys) {
    EXPECT_EQ(toByte(Curve::srgb, 0.18f), 118);  // a grey card
    EXPECT_EQ(toByte(Curve::srgb, 0.5f), 188);
    EXPECT_EQ(toByte(Curve::srgb, 0.2140f), 127);  // half the code is 0.21404
    EXPECT_EQ(toByte(Curve::srgb, 0.2141f), 128);
    EXPECT_EQ(toByte(Curve::srgb, 0.0031308f), 10);  // where the line ends and the power begins
    EXPECT_EQ(toByte(Curve::srgb, 0.001f), 3);
}

TEST(Srgb, NeverFalls) {
    int before = 0;
    for (int i = 0; i <= 1'000'000; ++i) {
        const int code = toByte(Curve::srgb, static_cast<float>(i) * 1e-6f);
        ASSERT_GE(code, before) << i;
        before = code;
    }
}

TEST(Srgb, EndsAtBlackAndWhite) {
    for (const float dark : {0.f, -0.f, -1e-30f, -1.f, -INFINITY}) EXPECT_EQ(toByte(Curve::srgb, dark), 0) << dark;
    for (const float bright : {1.f, 1.0001f, 7.f, 3e38f, INFINITY})
        EXPECT_EQ(toByte(Curve::srgb, bright), 255) << bright;
    EXPECT_EQ(toByte(Curve::srgb, 1e-40f), 0);
}

}  // namespace
}  // namespace image
