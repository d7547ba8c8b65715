// What is in a picture file.
#include "image/image_file.h"

#include "core/error.h"
#include "image/png_reader.h"
#include "image/temporary_folder.h"

#include <gmock/gmock.h>

namespace image {
namespace {

using testing::ElementsAre;
using testing::Pair;

Png written(const Film& film, double exposure = 0, const Metadata& metadata = {}) {
    const TemporaryFolder folder;
    ImageFile(folder / "picture.png").write(film, exposure, metadata);
    EXPECT_THAT(folder.names(), ElementsAre("picture.png"));
    return Png(folder / "picture.png");
}

TEST(ImageFile, HoldsEveryPixelInItsPlace) {
    Film film(5, 3, 0, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) film.at(x, y) = core::Rgbf(0.1f * float(x + 1), 0.3f * float(y + 1), 0.05f);
    const Png png = written(film);
    EXPECT_EQ(png.width, 5);
    EXPECT_EQ(png.height, 3);
    EXPECT_EQ(png.bitDepth, 8);
    EXPECT_EQ(png.colourType, PNG_COLOR_TYPE_RGB);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            const png_byte* pixel = &png.lines[static_cast<std::size_t>(y)][3 * static_cast<std::size_t>(x)];
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_EQ(pixel[channel], toByte(Curve::srgb, film.at(x, y)[channel]))
                    << x << " " << y << " " << channel;
        }
    }
}

TEST(ImageFile, ShowsRadianceTimesTwoToTheExposure) {
    Film film(1, 1, 0, 1);
    film.at(0, 0) = core::Rgbf(0.4f, 0.02f, -3);
    for (const double exposure : {-64.0, -1.5, 0.0, 1.0, 2.25, 64.0}) {
        const double factor = std::exp2(exposure);
        EXPECT_THAT(written(film, exposure).lines[0], ElementsAre(toByte(Curve::srgb, float(0.4f * factor)),
                                                                  toByte(Curve::srgb, float(0.02f * factor)), 0))
            << exposure;
    }
    EXPECT_THAT(written(film, 1).lines[0], ElementsAre(231, 56, 0));
}

// The standard's primaries and white, and the gamma that stands for the curve where sRGB is not known.
TEST(ImageFile, DeclaresItsColourSpace) {
    const TemporaryFolder folder;
    ImageFile(folder / "a.png").write(Film(1, 1, 0, 1), 0, {});
    EXPECT_THAT(chunkKinds(folder / "a.png"), testing::IsSupersetOf({"sRGB", "gAMA", "cHRM"}));
    const Png png(folder / "a.png");
    EXPECT_EQ(png.srgbIntent, PNG_sRGB_INTENT_RELATIVE);
    EXPECT_NEAR(png.gamma, 1 / 2.2, 1e-5);
    EXPECT_THAT(png.chromaticities,
                testing::Pointwise(testing::DoubleNear(1e-5), {0.3127, 0.3290, 0.64, 0.33, 0.30, 0.60, 0.15, 0.06}));
}

TEST(ImageFile, HoldsItsTextsToTheLetter) {
    const std::string longText(70'000, 'x');
    const Png png = written(Film(1, 1, 0, 1), 0,
                            {{"Software", "grsh 1.2"},
                             {"Scene", "b\xc3\xbchne \xe2\x98\x80.gr"},
                             {"grsh:lights", ""},
                             {"grsh:eye", "1 -2.5 1e-07"},
                             {"Comment", "one line\nand another"},
                             {"Long", longText}});
    EXPECT_THAT(png.texts, testing::UnorderedElementsAre(
                               Pair("Software", "grsh 1.2"), Pair("Scene", "b\xc3\xbchne \xe2\x98\x80.gr"),
                               Pair("grsh:lights", ""), Pair("grsh:eye", "1 -2.5 1e-07"),
                               Pair("Comment", "one line\nand another"), Pair("Long", longText)));
    // tEXt holds Latin-1, iTXt UTF-8.
    EXPECT_EQ(png.compressions.at("Software"), PNG_TEXT_COMPRESSION_NONE);
    EXPECT_EQ(png.compressions.at("Scene"), PNG_ITXT_COMPRESSION_NONE);
}

TEST(ImageFile, RecordsThePlaceOfAStrip) {
    Film film(4, 100, 30, 7);
    film.at(1, 30) = core::Rgbf(1, 0, 0);
    film.at(2, 36) = core::Rgbf(0, 1, 0);
    const Png png = written(film);
    EXPECT_EQ(png.height, 7);
    EXPECT_EQ(png.offset, std::pair(0, 30));
    EXPECT_THAT(png.lines[0], ElementsAre(0, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0, 0));
    EXPECT_THAT(png.lines[6], ElementsAre(0, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0, 0));
    EXPECT_EQ(written(Film(4, 100, 0, 7)).offset, std::pair(0, 0)) << "the first strip is one too";
    EXPECT_EQ(written(Film(4, 7, 0, 7)).offset, std::nullopt);
}

TEST(ImageFile, IsTheSameToTheByteTwice) {
    const TemporaryFolder folder;
    Film film(3, 2, 0, 2);
    film.at(2, 1) = core::Rgbf(0.3f, 0.2f, 0.1f);
    for (const char* name : {"a.png", "b.png"}) ImageFile(folder / name).write(film, 0.5, {{"Software", "grsh"}});
    EXPECT_EQ(bytesOf(folder / "a.png"), bytesOf(folder / "b.png"));
    EXPECT_FALSE(bytesOf(folder / "a.png").empty());
}

TEST(ImageFile, TakesItsEndingInAnyCase) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "b.PNG", "c.Png", "d.tar.png"}) {
        ImageFile(folder / name).write(Film(1, 1, 0, 1), 0, {});
        EXPECT_EQ(Png(folder / name).width, 1) << name;
    }
}

// A path without a folder is in the folder that one is in.
TEST(ImageFile, TakesAPathWithoutAFolder) {
    const TemporaryFolder folder;
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    ImageFile("plain.png").write(Film(1, 1, 0, 1), 0, {});
    std::filesystem::current_path(before);
    EXPECT_THAT(folder.names(), ElementsAre("plain.png"));
}

}  // namespace
}  // namespace image
