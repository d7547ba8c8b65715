#include "support/image_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/test_random.h"

namespace support {
namespace {

constexpr int pixels = 64 * 64;
constexpr double noise = 0.2;  // a pixel's standard error, as a share of its value

struct Image {
    std::vector<double> mean, varianceOfMean, reference;
};

// A gradient with normal noise, all of it brighter than its reference by the factor.
Image noisyImage(double factor) {
    TestRandom random(8);
    Image image;
    for (int i = 0; i < pixels; ++i) {
        const double reference = 0.1 + static_cast<double>(i) / pixels;
        const double radius = std::sqrt(-2 * std::log(1 - random.next()));
        const double normal = radius * std::cos(2 * std::numbers::pi * random.next());
        image.reference.push_back(reference);
        image.mean.push_back(reference * (factor + noise * normal));
        image.varianceOfMean.push_back(std::pow(noise * reference, 2));
    }
    return image;
}

ImageComparison compare(const Image& image) {
    return compareImages(image.mean, image.varianceOfMean, image.reference);
}

TEST(CompareImages, AcceptsAnImageWithTheNoiseItClaims) {
    const ImageComparison result = compare(noisyImage(1));
    EXPECT_TRUE(result.accepted) << result.text;
}

// A tenth of every pixel's noise: no pixel can tell, all of them together can.
TEST(CompareImages, RejectsAnErrorOfTheMeanThatNoPixelShows) {
    const ImageComparison result = compare(noisyImage(1.02));
    EXPECT_TRUE(result.pixels.accepted) << result.text;
    EXPECT_FALSE(result.mean.accepted) << result.text;
    EXPECT_FALSE(result.accepted);
}

// The other way round: one pixel is too dark by 8 standard errors, and two others make up for it.
TEST(CompareImages, RejectsPixelsThatTheMeanHides) {
    Image image = noisyImage(1);
    for (const int i : {100, 101, 102}) image.mean[i] = image.reference[i] * (1 + (i == 101 ? -8 : 4) * noise);
    const ImageComparison result = compare(image);
    EXPECT_FALSE(result.pixels.accepted) << result.text;
    EXPECT_TRUE(result.mean.accepted) << result.text;
    EXPECT_FALSE(result.accepted);
}

TEST(CompareImages, RejectsAPixelThatIsNotANumber) {
    Image image = noisyImage(1);
    image.mean[17] = std::numeric_limits<double>::quiet_NaN();
    const ImageComparison result = compare(image);
    EXPECT_FALSE(result.accepted);
    EXPECT_NE(result.text.find("number 17"), std::string::npos) << result.text;
    image = noisyImage(1);
    image.varianceOfMean[17] = -1;
    EXPECT_FALSE(compare(image).accepted);
}

// Black pixels, and those where every sample is the same, have no noise: equal but for rounding, they agree.
TEST(CompareImages, AcceptsPixelsWithoutNoise) {
    const std::vector<double> reference = {0, 0.3, 1}, none(3, 0);
    const std::vector<double> rounded = {0, static_cast<double>(0.3f), 1}, wrong = {0, 0.3, 1.001};
    EXPECT_TRUE(compareImages(rounded, none, reference).accepted);
    EXPECT_FALSE(compareImages(wrong, none, reference).accepted);
}

TEST(CompareImages, RefusesSizesThatDiffer) {
    const std::vector<double> three(3), two(2), none;
    EXPECT_THROW(compareImages(three, two, three), std::invalid_argument);
    EXPECT_THROW(compareImages(three, three, two), std::invalid_argument);
    EXPECT_THROW(compareImages(none, none, none), std::invalid_argument);
}

}  // namespace
}  // namespace support
