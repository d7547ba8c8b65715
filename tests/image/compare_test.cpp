// The figures of two pictures, worked out by hand.
#include "image/compare.h"

#include "image/image_samples.h"
#include "support/error_of.h"

#include <gmock/gmock.h>

namespace image {
namespace {

using support::errorOf;

using core::Rgbf;

template<class Number>
Image imageOf(std::string_view channels, std::vector<std::vector<Number>> numbers) {
    Image image = randomImage<Number>(static_cast<int>(numbers[0].size()), 1, channels);
    for (std::size_t c = 0; c < numbers.size(); ++c) image.channels[c].samples = numbers[c];
    return image;
}

TEST(Compare, FindsTheMeansAndTheLargestDifference) {
    const Colours a{2, 1, {Rgbf(0.5f, 0.25f, 3), Rgbf(0, 1, 1)}, {}};
    const Colours b{2, 1, {Rgbf(0.5f, 0.75f, 1), Rgbf(0, 1, 0)}, {}};
    const Comparison figures = compare(a, b);
    EXPECT_DOUBLE_EQ(figures.mse, (0.25 + 4 + 1) / 6);
    EXPECT_DOUBLE_EQ(figures.relmse, (0.25 / (0.5625 + 0.01) + 4 / 1.01 + 1 / 0.01) / 6);
    // 3 shows as 1; by IEC 61966-2-1, 0.25 as 0.537099 and 0.75 as 0.880825.
    const double shownError = (0.343726 * 0.343726 + 1) / 6;
    EXPECT_NEAR(figures.psnr, -10 * std::log10(shownError), 1e-4);
    EXPECT_EQ(figures.largest, 2);
    EXPECT_EQ(figures.x, 0);
    EXPECT_EQ(compare(b, a).largest, 2);
    EXPECT_NE(compare(b, a).relmse, figures.relmse) << "b is the reference";
}

TEST(Compare, FindsWhereTheyDifferMost) {
    Colours a{5, 4, std::vector<Rgbf>(20, Rgbf(1)), {}}, b = a;
    a.pixels[13].z = 1.5f;
    a.pixels[6].x = 0.75f;
    const Comparison figures = compare(a, b);
    EXPECT_EQ(figures.x, 3);
    EXPECT_EQ(figures.y, 2);
    EXPECT_EQ(figures.largest, 0.5);
}

TEST(Compare, FindsNothingInTheSamePicture) {
    const Colours a{2, 1, {Rgbf(0.1f, -2, 1e30f), Rgbf(0)}, {}};
    const Comparison figures = compare(a, a);
    EXPECT_EQ(figures.mse, 0);
    EXPECT_EQ(figures.relmse, 0);
    EXPECT_EQ(figures.largest, 0);
    EXPECT_EQ(figures.psnr, std::numeric_limits<double>::infinity());
}

TEST(ColoursOf, AreLinear) {
    const Image shallow = imageOf<std::uint8_t>("RGB", {{0, 255}, {10, 188}, {1, 128}});
    const Colours colours = coloursOf(shallow, "a");
    EXPECT_EQ(colours.width, 2);
    EXPECT_EQ(colours.pixels[0].x, 0);
    EXPECT_EQ(colours.pixels[1].x, 1);
    EXPECT_NEAR(colours.pixels[0].y, 10 / 255. / 12.92, 1e-8);
    EXPECT_NEAR(colours.pixels[1].y, 0.502886, 1e-6);
    EXPECT_NEAR(colours.pixels[1].z, 0.215861, 1e-6);
    const Colours deep = coloursOf(imageOf<std::uint16_t>("RGB", {{65535}, {48316}, {0}}), "a");
    EXPECT_NEAR(deep.pixels[0].y, 0.502886, 1e-6) << "188 * 257";
    const Colours floats = coloursOf(imageOf<float>("ZBGR", {{9}, {-1}, {5}, {0.25f}}), "a");
    EXPECT_EQ(floats.pixels[0], Rgbf(0.25f, 5, -1));
    const Colours grey = coloursOf(imageOf<float>("Y", {{0.25f}}), "a");
    EXPECT_EQ(grey.pixels[0], Rgbf(0.25f));
}

TEST(ColoursOf, RefusesWhatItCannotCompare) {
    const auto error = [](const Image& image) { return errorOf([&] { coloursOf(image, "a.x"); }); };
    EXPECT_EQ(error(imageOf<float>("RBZ", {{1}, {1}, {1}})),
              "COMPARE PICTURE [a.x] cannot compare \"a.x\": it has the channels R B Z, not R, G and B");
    for (const float x : {core::infinity, -core::infinity, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_EQ(error(imageOf<float>("RGB", {{1, 1, 1}, {1, 1, x}, {1, 1, 1}})),
                  "COMPARE PICTURE [a.x] cannot compare \"a.x\": its pixel 2 0 is not finite");
    EXPECT_EQ(error(imageOf<float>("RGBA", {{1, 1}, {1, 1}, {1, 1}, {1, core::infinity}})),
              "COMPARE PICTURE [a.x] cannot compare \"a.x\": its pixel 1 0 is not finite");
}

// What shows before black: a PNG's colours times how much they cover, an OpenEXR file's as they are.
TEST(ColoursOf, OfTransparentPicturesAreWhatShows) {
    const Colours bytes = coloursOf(imageOf<std::uint8_t>("RGBA", {{255, 188}, {255, 188}, {255, 188}, {51, 0}}), "a");
    EXPECT_FLOAT_EQ(bytes.pixels[0].x, 0.2f);
    EXPECT_EQ(bytes.pixels[1], Rgbf(0));
    EXPECT_THAT(bytes.coverage, testing::ElementsAre(0.2f, 0));
    const Colours floats = coloursOf(imageOf<float>("RGBA", {{0.5f}, {0.25f}, {3}, {0.5f}}), "a");
    EXPECT_EQ(floats.pixels[0], Rgbf(0.5f, 0.25f, 3));
    EXPECT_THAT(floats.coverage, testing::ElementsAre(0.5f));
    EXPECT_TRUE(coloursOf(imageOf<std::uint8_t>("RGBA", {{1}, {1}, {1}, {255}}), "a").coverage.empty());
    EXPECT_TRUE(coloursOf(imageOf<std::uint16_t>("YA", {{1}, {65535}}), "a").coverage.empty());
}

TEST(ColoursOf, GoByTheGammaThatAPictureTells) {
    Image image = imageOf<std::uint16_t>("Y", {{65535, 32768, 0}});
    image.gamma = 1;
    EXPECT_FLOAT_EQ(coloursOf(image, "a").pixels[1].x, 32768 / 65535.f);
    image.gamma = 0.5;
    EXPECT_FLOAT_EQ(coloursOf(image, "a").pixels[1].x, 32768 / 65535.f * 32768 / 65535.f);
    EXPECT_EQ(coloursOf(image, "a").pixels[0].x, 1);
}

// With a fourth number of each pixel where one of them is transparent.
TEST(Compare, CountsHowMuchPixelsCover) {
    Colours a{2, 1, {Rgbf(0.5f), Rgbf(0)}, {1, 0.25f}};
    const Colours b{2, 1, {Rgbf(0.5f), Rgbf(0)}, {}};
    const Comparison figures = compare(a, b);
    EXPECT_DOUBLE_EQ(figures.mse, 0.5625 / 8);
    EXPECT_DOUBLE_EQ(figures.relmse, 0.5625 / 1.01 / 8);
    EXPECT_NEAR(figures.psnr, -10 * std::log10(0.5625 / 8), 1e-9);
    EXPECT_EQ(figures.largest, 0.75);
    EXPECT_EQ(figures.x, 1);
    EXPECT_EQ(compare(b, a).largest, 0.75);
}

}  // namespace
}  // namespace image
