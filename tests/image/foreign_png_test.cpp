// PNG files that other programs write.
#include "image/icc_samples.h"
#include "image/image_file.h"
#include "image/png_reader.h"
#include "image/primaries.h"
#include "image/temporary_folder.h"
#include "support/error_of.h"

#include <gmock/gmock.h>
#include <png.h>
#include <zlib.h>

#include <cstdio>
#include <functional>
#include <stdexcept>

namespace image {
namespace {

using support::errorOf;

using testing::ElementsAre;
using testing::EndsWith;
using testing::Pair;

// A PNG of the raw lines given. set: what else is in its header.
void writeRawPng(
    const std::string& path, int width, int bitDepth, int colourType, int interlace,
    std::vector<std::vector<png_byte>> lines,
    const std::function<void(png_structp, png_infop)>& set = [](png_structp, png_infop) {}) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(lines.size()), bitDepth,
                 colourType, interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    set(png, info);
    png_write_info(png, info);
    std::vector<png_bytep> rows;
    for (auto& line : lines) rows.push_back(line.data());
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

std::vector<int> bytesIn(const Image& image, const std::string& channel) {
    const ImageChannel* found = image.find(channel);
    if (found == nullptr) throw std::runtime_error("no channel " + channel);
    const auto& samples = std::get<std::vector<std::uint8_t>>(found->samples);
    return {samples.begin(), samples.end()};
}

TEST(ForeignPng, OfAPaletteBecomesColours) {
    const TemporaryFolder folder;
    const auto setPalette = [](png_structp png, png_infop info) {
        const png_color colours[] = {{10, 20, 30}, {40, 50, 60}, {70, 80, 90}};
        png_set_PLTE(png, info, colours, 3);
    };
    const auto setTransparency = [&](png_structp png, png_infop info) {
        setPalette(png, info);
        const png_byte alpha[] = {255, 0};
        png_set_tRNS(png, info, alpha, 2, nullptr);
    };
    // Two bits a pixel: 0 1 2 1.
    writeRawPng(folder / "a.png", 4, 2, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE, {{0b00011001}}, setPalette);
    writeRawPng(folder / "b.png", 4, 2, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE, {{0b00011001}}, setTransparency);
    const Image opaque = readImage(folder / "a.png"), transparent = readImage(folder / "b.png");
    EXPECT_EQ(opaque.channelNames(), "R G B");
    EXPECT_THAT(bytesIn(opaque, "R"), ElementsAre(10, 40, 70, 40));
    EXPECT_THAT(bytesIn(opaque, "B"), ElementsAre(30, 60, 90, 60));
    EXPECT_EQ(transparent.channelNames(), "R G B A");
    EXPECT_THAT(bytesIn(transparent, "G"), ElementsAre(20, 50, 80, 50));
    EXPECT_THAT(bytesIn(transparent, "A"), ElementsAre(255, 0, 255, 0));
}

TEST(ForeignPng, OfFewBitsOrInterlaced) {
    const TemporaryFolder folder;
    writeRawPng(folder / "bits.png", 4, 1, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{0b10100000}, {0b01100000}});
    const Image bits = readImage(folder / "bits.png");
    EXPECT_EQ(bits.channelNames(), "Y");
    EXPECT_THAT(bytesIn(bits, "Y"), ElementsAre(255, 0, 255, 0, 0, 255, 255, 0));
    std::vector<std::vector<png_byte>> lines(9, std::vector<png_byte>(11));
    std::vector<int> numbers;
    for (int i = 0; i < 99; ++i) {
        lines[std::size_t(i) / 11][std::size_t(i) % 11] = png_byte(2 * i);
        numbers.push_back(2 * i);
    }
    writeRawPng(folder / "adam7.png", 11, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_ADAM7, lines);
    EXPECT_EQ(bytesIn(readImage(folder / "adam7.png"), "Y"), numbers);
}

TEST(ForeignPng, TextsInLatin1BecomeUtf8) {
    const TemporaryFolder folder;
    char key[] = "Author", value[] = "Andr\xe9";
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_zTXt;
    text.key = key;
    text.text = value;
    text.text_length = 5;
    writeRawPng(folder / "a.png", 1, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{7}},
                [&](png_structp png, png_infop info) { png_set_text(png, info, &text, 1); });
    EXPECT_THAT(readImage(folder / "a.png").metadata, ElementsAre(Pair("Author", "Andr\xc3\xa9")));
}

class ForeignPngColours : public testing::Test {
protected:
    using Set = std::function<void(png_structp, png_infop)>;

    // What reading a grey pixel of 7 says, or its gamma.
    std::string outcome(const Set& set) {
        writeRawPng(folder_ / "a.png", 1, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{7}}, set);
        std::string text = errorOf([&] { gamma_ = readImage(folder_ / "a.png").gamma; });
        const std::string start = "cannot read \"" + (folder_ / "a.png") + "\": ";
        const std::size_t found = text.find(start);
        return found == std::string::npos ? text : text.substr(found + start.size());
    }

    TemporaryFolder folder_;
    double gamma_ = -1;
};

void setPrimaries(png_structp png, png_infop info, const Primaries& p) {
    png_set_gAMA(png, info, 0.45455);
    png_set_cHRM(png, info, p[6], p[7], p[0], p[1], p[2], p[3], p[4], p[5]);
}

void addChunk(png_structp png, png_infop info, const png_unknown_chunk& chunk) {
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, nullptr, 0);
    png_set_unknown_chunks(png, info, &chunk, 1);
}

TEST_F(ForeignPngColours, OfAGammaAreReadByIt) {
    for (const double gamma : {1., 0.55556, 0.45455 / 2}) {
        EXPECT_EQ(outcome([&](png_structp png, png_infop info) { png_set_gAMA(png, info, gamma); }), "no error");
        EXPECT_NEAR(gamma_, gamma, 1e-5);
        ImageFile(folder_ / "b.png").write(readImage(folder_ / "a.png"));
        EXPECT_NEAR(Png(folder_ / "b.png").gamma, gamma, 1e-5);
        EXPECT_EQ(Png(folder_ / "b.png").srgbIntent, std::nullopt);
    }
    for (const double gamma : {0.45455, 0.44, 0.47}) {
        EXPECT_EQ(outcome([&](png_structp png, png_infop info) { png_set_gAMA(png, info, gamma); }), "no error");
        EXPECT_EQ(gamma_, 0);
    }
    EXPECT_EQ(outcome([](png_structp, png_infop) {}), "no error");
    EXPECT_EQ(gamma_, 0);
}

TEST_F(ForeignPngColours, OfOtherPrimariesAreRefusedByName) {
    const auto with = [&](const Primaries& primaries) {
        return outcome([&](png_structp png, png_infop info) { setPrimaries(png, info, primaries); });
    };
    EXPECT_EQ(with(srgbPrimaries), "no error");
    EXPECT_EQ(with({0.6401, 0.3299, 0.3, 0.6001, 0.15, 0.06, 0.3128, 0.3291}), "no error");
    EXPECT_EQ(with({0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290}),
              "its primaries are those of Display P3, not of sRGB");
    EXPECT_EQ(with({0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290}),
              "its primaries are those of BT.2020, not of sRGB");
    EXPECT_EQ(with({0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.3290}),
              "its primaries are those of Adobe RGB, not of sRGB");
    EXPECT_EQ(with({0.63, 0.34, 0.31, 0.595, 0.155, 0.07, 0.3127, 0.3290}),
              "its primaries are other than those of sRGB");
    EXPECT_EQ(outcome([](png_structp png, png_infop info) {
                  setPrimaries(png, info, {0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290});
                  png_byte intent = PNG_sRGB_INTENT_PERCEPTUAL;
                  png_unknown_chunk chunk{"sRGB", &intent, 1, PNG_HAVE_IHDR};
                  addChunk(png, info, chunk);
              }),
              "no error");
}

TEST_F(ForeignPngColours, OfCodePointsGoBeforeAllElse) {
    const auto with = [&](std::array<png_byte, 4> points) {
        return outcome([&](png_structp png, png_infop info) {
            png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
            png_unknown_chunk chunk{"cICP", points.data(), 4, PNG_HAVE_IHDR};
            addChunk(png, info, chunk);
        });
    };
    EXPECT_EQ(with({1, 13, 0, 1}), "no error");
    EXPECT_EQ(gamma_, 0);
    EXPECT_EQ(with({1, 8, 0, 1}), "no error");
    EXPECT_EQ(gamma_, 1);
    EXPECT_EQ(with({9, 16, 0, 1}), "its primaries are those of BT.2020, not of sRGB");
    EXPECT_EQ(with({12, 13, 0, 1}), "its primaries are those of Display P3, not of sRGB");
    EXPECT_EQ(with({1, 16, 0, 1}), "its curve is PQ, not that of sRGB");
    EXPECT_EQ(with({1, 1, 0, 1}), "its curve is number 1 of H.273, not that of sRGB");
    EXPECT_EQ(with({1, 13, 0, 0}), "its numbers are not red, green and blue of full range");
}

TEST_F(ForeignPngColours, OfAProfileAreThoseOfSrgbOrRefusedByName) {
    const auto with = [&](const std::string& profile) {
        return outcome([&](png_structp png, png_infop info) {
            png_set_iCCP(png, info, "icc", 0, reinterpret_cast<png_const_bytep>(profile.data()),
                         static_cast<png_uint_32>(profile.size()));
        });
    };
    EXPECT_EQ(with(greyProfile("Mine", srgbCurve())), "no error");
    EXPECT_EQ(with(greyProfile("Dot Gain 20%", powerCurve(1.75))),
              "its colours are those of the profile \"Dot Gain 20%\", not those of sRGB");
    EXPECT_EQ(with(greyProfile("", powerCurve(1.75))),
              "its colours are those of the profile \"icc\", not those of sRGB");
}

// A few bytes may announce much.
TEST(ForeignPng, ThatAnnouncesMoreThanItHasIsRefusedAtOnce) {
    const TemporaryFolder folder;
    const std::string path = folder / "a.png";
    const auto error = [&] { return errorOf([&] { readImage(path); }); };
    writeRawPng(path, 1, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{7}});
    std::string bytes = bytesOf(path);
    // 30000 x 30000 pixels, with the checksum of that.
    bytes.replace(16, 8, std::string("\0\0\x75\x30\0\0\x75\x30", 8));
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(&bytes[12]), 17);
    for (unsigned i = 0; i < 4; ++i) bytes[29 + i] = static_cast<char>(sum >> (24 - 8 * i));
    writeText(path, bytes);
    EXPECT_THAT(error(),
                EndsWith(": it announces 30000 x 30000 pixels and has " + std::to_string(bytes.size()) + " bytes"));
    // A text of 2 GB that is not there; and one that unpacks to 40 MB.
    writeText(path, bytesOf(path).substr(0, 33) + std::string("\x7f\xff\xff\xf0tEXtComment\0xxxx", 20));
    EXPECT_THAT(error(), EndsWith(": its tEXt chunk takes more than 32 MB"));
    std::string value(40'000'000, 'x');
    char key[] = "Comment";
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_zTXt;
    text.key = key;
    text.text = value.data();
    text.text_length = value.size();
    writeRawPng(path, 1, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{7}},
                [&](png_structp png, png_infop info) { png_set_text(png, info, &text, 1); });
    EXPECT_LT(bytesOf(path).size(), 50'000u);
    EXPECT_THAT(error(), EndsWith(": its zTXt chunk is cut off or takes more than 32 MB"));
}

// Zeros are packed as well as deflate can.
TEST(ForeignPng, OfOneColourIsReadHoweverSmallItIs) {
    const TemporaryFolder folder;
    writeRawPng(folder / "a.png", 3000, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                std::vector<std::vector<png_byte>>(3000, std::vector<png_byte>(3000)));
    EXPECT_LT(bytesOf(folder / "a.png").size(), 12'000u);
    EXPECT_EQ(readImage(folder / "a.png").pixels(), 9'000'000u);
}

}  // namespace
}  // namespace image
