// The path integrator's random numbers: one sample's are independent over the pixels, one pixel's are spread evenly.
// Seen to fail with seeds of the four coordinates that share their last bits, with one seed for all points, with a
// column of Sobol's matrix missing, with the samples' order shuffled over all of them, and with no scrambling.
#include "render/transport/owen_sobol.h"

#include "support/chi_square.h"

#include <gtest/gtest.h>

#include <set>

namespace render {
namespace {

using Random = OwenSobol<float>;

std::uint32_t pixelOf(std::uint32_t x, std::uint32_t y) {
    return mixed(x + mixed(y + 0x1234567));
}

// How often 2^20 pixels fall into each of so many cells; cell(x, y) is the pixel's.
template<class Cell>
std::vector<double> countInPixels(std::size_t cells, const Cell& cell) {
    std::vector<double> count(cells);
    for (std::uint32_t y = 0; y < 1024; ++y)
        for (std::uint32_t x = 0; x < 1024; ++x) ++count[cell(x, y)];
    return count;
}

void expectEven(const std::vector<double>& counts, const std::string& what) {
    const std::vector<double> expected(counts.size(), double{1 << 20} / static_cast<double>(counts.size()));
    const support::ChiSquareResult result = support::chiSquareTest(counts, expected);
    EXPECT_TRUE(result.accepted) << what << ": " << result.text;
}

// Which of `parts` equal parts of [0, 1) each coordinate is in, as one number.
std::size_t cellOf(const Point4<float>& point, std::size_t parts, std::size_t cell = 0) {
    for (const float x : point) cell = cell * parts + static_cast<std::size_t>(x * static_cast<float>(parts));
    return cell;
}

class OneSampleOfManyPixels : public testing::TestWithParam<std::uint32_t> {};

TEST_P(OneSampleOfManyPixels, FillsTheHypercube) {
    const std::uint32_t sample = GetParam();
    const auto point = [&](std::uint32_t x, std::uint32_t y) { return Random(pixelOf(x, y), sample, 6).point(2); };
    expectEven(countInPixels(256, [&](auto x, auto y) { return cellOf(point(x, y), 4); }), "four coordinates");
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = a + 1; b < 4; ++b)
            expectEven(countInPixels(1024,
                                     [&](auto x, auto y) {
                                         const Point4<float> p = point(x, y);
                                         return static_cast<std::size_t>(p[a] * 32) * 32 +
                                                static_cast<std::size_t>(p[b] * 32);
                                     }),
                       "coordinates " + std::to_string(a) + " and " + std::to_string(b));
}

TEST_P(OneSampleOfManyPixels, KnowsNothingOfAnother) {
    const std::uint32_t sample = GetParam();
    const auto point = [&](std::uint32_t x, std::uint32_t y, std::uint32_t number) {
        return Random(pixelOf(x, y), sample, 6).point(number);
    };
    expectEven(countInPixels(256, [&](auto x, auto y) { return cellOf(point(x, y, 3), 2, cellOf(point(x, y, 2), 2)); }),
               "the next point");
    expectEven(
        countInPixels(256, [&](auto x, auto y) { return cellOf(point(x + 1, y, 2), 2, cellOf(point(x, y, 2), 2)); }),
        "the next pixel");
    expectEven(
        countInPixels(256, [&](auto x, auto y) { return cellOf(point(x, y + 1, 2), 2, cellOf(point(x, y, 2), 2)); }),
        "the next line");
}

INSTANTIATE_TEST_SUITE_P(Sample, OneSampleOfManyPixels, testing::Values(0, 1, 3, 12, 37));

// How many of a pixel's samples `first` to `end` - 1 share a box of 2^a x 2^b with one before them.
int sharedBoxes(std::uint32_t pixel, std::uint32_t first, std::uint32_t end, std::size_t x, std::size_t y, int a,
                int b) {
    std::set<std::pair<int, int>> boxes;
    for (std::uint32_t sample = first; sample < end; ++sample) {
        const Point4<float> point = Random(pixel, sample, 10).point(5);
        boxes.insert({static_cast<int>(std::ldexp(point[x], a)), static_cast<int>(std::ldexp(point[y], b))});
    }
    return static_cast<int>(end - first) - static_cast<int>(boxes.size());
}

// One in each box of every shape in the first two coordinates, one in each slice of any one: from sample 0 on, and in
// any later row of 2^k samples that begins at a multiple of 2^k.
TEST(SamplesOfAPixel, LieOneInEachBox) {
    for (std::uint32_t pixel = 0; pixel < 20; ++pixel)
        for (int k = 0; k <= 8; ++k)
            for (const std::uint32_t row : {0u, 1u, 2u, 3u}) {
                const std::uint32_t first = row << k, end = first + (1u << k);
                for (int a = 0; a <= k; ++a)
                    ASSERT_EQ(sharedBoxes(pixelOf(pixel, 3), first, end, 0, 1, a, k - a), 0)
                        << "samples " << first << " to " << end - 1 << ", 2^" << a << " columns";
                for (const std::size_t coordinate : {2u, 3u})
                    ASSERT_EQ(sharedBoxes(pixelOf(pixel, 3), first, end, coordinate, 0, k, 0), 0)
                        << "samples " << first << " to " << end - 1 << ", coordinate " << coordinate;
            }
}

// How many bits a picture's last sample has does not matter to the others, nor which block a sample is in.
TEST(SamplesOfAPixel, DoNotDependOnTheirNumber) {
    for (std::uint32_t sample = 0; sample < 300; ++sample) {
        const int least = std::bit_width(sample);
        const Point4<float> expected = Random(77, sample, 32).point(9);
        for (int bits = least; bits < 32; ++bits) ASSERT_EQ(Random(77, sample, bits).point(9), expected) << sample;
    }
}

TEST(SamplesOfAPixel, AreBelow1) {
    // The last number that a float can hold below 1 is drawn, and 0.
    float least = 1, most = 0;
    for (std::uint32_t i = 0; i < 20'000'000; ++i) {
        const Point4<float> point = Random(mixed(i), i & 15, 4).point(i >> 20);
        for (const float x : point) {
            least = std::min(least, x);
            most = std::max(most, x);
        }
    }
    EXPECT_EQ(least, 0);
    EXPECT_EQ(most, 1 - 0x1p-24f);
}

}  // namespace
}  // namespace render
