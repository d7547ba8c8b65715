// FLIP: closed cases, and what its authors' own program (flip-evaluator 1.7) says of the same pictures. It has the
// matrices of sRGB to fewer digits: that makes 3e-5.
#include "image/flip.h"

#include "image/image_file.h"

#include <gmock/gmock.h>

#include <numeric>

namespace image {
namespace {

using core::Rgbf;

constexpr int width = 56, height = 40;

// value: sRGB at x, y, each channel from 0 to 1.
template<class Value>
std::vector<Rgbf> picture(const Value& value) {
    std::vector<Rgbf> pixels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 srgb = value(x, y);
            pixels.emplace_back(decodeSrgb(srgb.x), decodeSrgb(srgb.y), decodeSrgb(srgb.z));
        }
    }
    return pixels;
}
std::vector<Rgbf> plain(const glm::dvec3& srgb) {
    return picture([&](int, int) { return srgb; });
}

struct Figures {
    double mean, largest;
};
Figures figuresOf(const std::vector<Rgbf>& test, const std::vector<Rgbf>& reference) {
    const std::vector<float> map = flip(reference, test, width, height);
    return {std::accumulate(map.begin(), map.end(), 0.) / double(map.size()),
            *std::max_element(map.begin(), map.end())};
}

void expectFigures(const std::vector<Rgbf>& test, const std::vector<Rgbf>& reference, double mean, double largest) {
    const Figures figures = figuresOf(test, reference);
    EXPECT_NEAR(figures.mean, mean, 5e-5);
    EXPECT_NEAR(figures.largest, largest, 5e-5);
}

glm::dvec3 gradient(int x, int y) {
    return {x / (width - 1.), y / (height - 1.), (x + y) / (width + height - 2.)};
}

TEST(Flip, OfTheSameIsNothing) {
    EXPECT_EQ(figuresOf(picture(gradient), picture(gradient)).largest, 0);
}

// Without features the colours alone count. Black and white lie 100 apart, green and blue as far as colours can: from
// their CIELAB coordinates, 87.7347 -86.1827 83.1793 and 32.2970 79.1875 -107.8602, each chroma times lightness / 100.
TEST(Flip, OfPlainPicturesIsTheDistanceOfTheirColours) {
    const double largest = std::pow(55.4377 + std::hypot(75.6123 + 25.5752, 72.9772 + 34.8356), 0.7);
    const double blackToWhite = std::pow(100, 0.7), bend = 0.4 * largest;
    const double expected = 0.95 + 0.05 * (blackToWhite - bend) / (largest - bend);
    for (const auto& [a, b] : {std::pair(0, 1), {1, 0}})
        for (const float difference : flip(plain(glm::dvec3(a)), plain(glm::dvec3(b)), width, height))
            ASSERT_NEAR(difference, expected, 1e-5);
    EXPECT_NEAR(figuresOf(plain({0, 1, 0}), plain({0, 0, 1})).mean, 1, 1e-6);
}

TEST(Flip, OfPlainPicturesIsWhatItsAuthorsHave) {
    expectFigures(plain({0, 1, 0}), plain({1, 0, 0}), 0.986684, 0.986684);
    expectFigures(plain({0.52, 0.5, 0.5}), plain({0.5, 0.5, 0.5}), 0.0775147, 0.0775147);
    expectFigures(plain({0.25, 0.35, 0.6}), plain({0.2, 0.4, 0.6}), 0.2334798, 0.2334798);
}

TEST(Flip, OfFeaturesIsWhatItsAuthorsHave) {
    const auto patch = [](int x, int y) {
        const glm::dvec3 colour = gradient(x, y);
        return x >= 15 && x < 30 && y >= 10 && y < 20 ? glm::dvec3(colour.z, colour.y, colour.x) : colour;
    };
    const auto line = [](int x, int) { return glm::dvec3(x == 20 ? 1 : 0.2); };
    const auto point = [](int x, int y) { return glm::dvec3(x == 20 && y == 20 ? 1 : 0.2); };
    expectFigures(picture(patch), picture(gradient), 0.0122833, 0.1941007);
    expectFigures(picture(line), plain(glm::dvec3(0.2)), 0.0760158, 0.9282024);
    expectFigures(picture(point), plain(glm::dvec3(0.2)), 0.0040421, 0.6583661);
}

// What is beyond white is shown white.
TEST(Flip, SeesNoMoreThanIsShown) {
    const std::vector<Rgbf> bright(width * height, Rgbf(7, 1, 50)), white(width * height, Rgbf(1));
    EXPECT_EQ(figuresOf(bright, white).largest, 0);
}

}  // namespace
}  // namespace image
