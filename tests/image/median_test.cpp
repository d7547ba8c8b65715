// The median filter against the plain one, in every pixel.
#include "image/median.h"

#include "core/vec.h"
#include "image/image_samples.h"
#include "image/plain_median.h"

#include <gmock/gmock.h>

#include <cmath>

namespace image {
namespace {

using testing::ElementsAre;

template<class Number>
class Median : public testing::Test {};
using Numbers = testing::Types<std::uint8_t, std::uint16_t, float>;
TYPED_TEST_SUITE(Median, Numbers);

// Smaller than the window, thin, of several pieces of a line, and of several tasks.
TYPED_TEST(Median, IsThePlainOneOnRandomPictures) {
    std::uint64_t seed = 0;
    for (int n = 1; n <= 15; n += 2) {
        for (const auto& [width, height] :
             {std::pair(1, 1), {2, 2}, {5, 3}, {3, 40}, {40, 3}, {15, 15}, {16, 17}, {31, 33}, {1100, 16}, {129, 70}}) {
            const auto numbers = randomNumbers<TypeParam>(std::size_t(width) * std::size_t(height), ++seed);
            EXPECT_TRUE(medianFilter<TypeParam>(numbers, width, height, n) ==
                        plainMedianFilter(numbers, width, height, n))
                << n << ": " << width << " x " << height;
        }
    }
}

// Few different numbers, the least and the greatest among them: many are alike.
TYPED_TEST(Median, IsThePlainOneWhereNumbersAreAlike) {
    for (int n = 1; n <= 15; n += 2) {
        auto numbers = randomNumbers<TypeParam>(60 * 50, 99 + std::uint64_t(n));
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (i % 3 == 0) numbers[i] = std::numeric_limits<TypeParam>::lowest();
            if (i % 5 == 0) numbers[i] = std::numeric_limits<TypeParam>::max();
            if (i % 7 == 0) numbers[i] = TypeParam(1);
        }
        EXPECT_TRUE(medianFilter<TypeParam>(numbers, 60, 50, n) == plainMedianFilter(numbers, 60, 50, n)) << n;
    }
}

TYPED_TEST(Median, IsTheSameOnAnyNumberOfThreads) {
    const auto numbers = randomNumbers<TypeParam>(90 * 70, 5);
    const auto one = medianFilter<TypeParam>(numbers, 90, 70, 7, 1);
    for (const int threads : {2, 3, 8}) EXPECT_TRUE(medianFilter<TypeParam>(numbers, 90, 70, 7, threads) == one);
}

// Worked out by hand: 3 x 3 in the middle, 2 x 2 in a corner, 2 x 3 at an edge.
TEST(MedianByHand, CutsTheWindowOffAtTheEdges) {
    const std::vector<std::uint8_t> numbers{1, 2, 9,  //
                                            4, 5, 6,  //
                                            7, 8, 3};
    EXPECT_THAT(medianFilter<std::uint8_t>(numbers, 3, 3, 3),
                ElementsAre(3, 5, 6,  // of 1 2 4 5; 1 2 4 5 6 9: 4.5; 2 5 6 9: 5.5
                            5, 5, 6,  // of 1 2 4 5 7 8: 4.5; all; 2 3 5 6 8 9: 5.5
                            6, 6, 6));  // of 4 5 7 8; 3 4 5 6 7 8: 5.5; 3 5 6 8: 5.5
    const std::vector<float> floats{1, 2, 4, 8};
    EXPECT_THAT(medianFilter<float>(floats, 4, 1, 3), ElementsAre(1.5f, 2, 4, 6));
}

TEST(MedianByHand, TakesOutSinglePixels) {
    std::vector<std::uint16_t> numbers(20 * 20, 1000);
    for (std::size_t i = 0; i < numbers.size(); i += 7) numbers[i] = 65535;
    EXPECT_THAT(medianFilter<std::uint16_t>(numbers, 20, 20, 5), testing::Each(1000));
}

TEST(MedianByHand, OrdersWhatIsNoOrdinaryFloat) {
    constexpr float inf = core::infinity, nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> numbers{nan, -nan, -inf, -2, inf, -0.f, 3, nan, nan};
    const std::vector<float> medians = medianFilter<float>(numbers, 3, 3, 3);
    EXPECT_EQ(medians[4], inf) << "the fifth: four are NaN";
    EXPECT_TRUE(std::isnan(medianFilter<float>(std::vector{nan, nan, 1.f}, 3, 1, 3)[1]));
}

TEST(MedianOfAnImage, FiltersEachChannelByItself) {
    Image image = randomImage<std::uint8_t>(30, 20, "RGBA");
    const Image before = image;
    applyMedian(image, 5);
    for (std::size_t c = 0; c < 4; ++c)
        EXPECT_EQ(std::get<0>(image.channels[c].samples),
                  plainMedianFilter(std::get<0>(before.channels[c].samples), 30, 20, 5));
    EXPECT_EQ(image.channelNames(), "R G B A");
}

}  // namespace
}  // namespace image
