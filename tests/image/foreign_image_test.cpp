// Pictures that other programs write.
#include "image/image_file.h"
#include "image/temporary_folder.h"
#include "support/error_of.h"

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <half.h>
#include <png.h>

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

TEST(ForeignPng, OfOtherColoursIsRefused) {
    const TemporaryFolder folder;
    const auto write = [&](const std::function<void(png_structp, png_infop)>& set) {
        writeRawPng(folder / "a.png", 1, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{7}}, set);
        return errorOf([&] { readImage(folder / "a.png"); });
    };
    EXPECT_THAT(write([](png_structp png, png_infop info) { png_set_gAMA(png, info, 1); }),
                EndsWith(": its gamma is 1, not that of sRGB, 0.45455"));
    EXPECT_EQ(write([](png_structp png, png_infop info) { png_set_gAMA(png, info, 0.45455); }), "no error");
    EXPECT_EQ(write([](png_structp, png_infop) {}), "no error");
}

// A row of numbers k, k + 1, ... in a channel of OpenEXR's C++ library.
template<class Number>
void writeExrChannel(const std::string& path, Imf::Header header, const char* name, Imf::PixelType type) {
    const Imath::Box2i window = header.dataWindow();
    const std::size_t width = std::size_t(window.max.x - window.min.x + 1),
                      lines = std::size_t(window.max.y - window.min.y + 1);
    std::vector<Number> numbers(width * lines);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = Number(float(i) / 4);
    header.channels().insert(name, Imf::Channel(type));
    Imf::FrameBuffer buffer;
    buffer.insert(name, Imf::Slice::Make(type, numbers.data(), window, sizeof(Number), width * sizeof(Number)));
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(int(lines));
}

TEST(ForeignExr, OfHalfFloatsOfEveryLosslessCompression) {
    const TemporaryFolder folder;
    for (const auto compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                   Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
        for (const auto order : {Imf::INCREASING_Y, Imf::DECREASING_Y}) {
            Imf::Header header(40, 60, {{-2, -3}, {30, 41}}, 1, {0, 0}, 1, order, compression);
            writeExrChannel<half>(folder / "a.exr", header, "Y", Imf::HALF);
            const Image image = readImage(folder / "a.exr");
            EXPECT_EQ(image.held, (Window{-2, -3, 33, 45}));
            EXPECT_EQ(image.whole, (Window{0, 0, 40, 60}));
            const auto& numbers = std::get<std::vector<float>>(image.channels.at(0).samples);
            for (std::size_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(numbers[i], float(half(float(i) / 4))) << i;
        }
    }
}

TEST(ForeignExr, ThatIsNotReadSaysWhy) {
    const TemporaryFolder folder;
    const std::string path = folder / "a.exr";
    const auto error = [&] { return errorOf([&] { readImage(path); }); };
    writeExrChannel<unsigned>(path, Imf::Header(4, 4), "id", Imf::UINT);
    EXPECT_THAT(error(), EndsWith(": its channel \"id\" holds whole numbers"));

    Imf::Header wide(4, 4);
    Imf::addChromaticities(wide,
                           Imf::Chromaticities({0.7347f, 0.2653f}, {0, 1}, {0.0001f, -0.077f}, {0.32168f, 0.33767f}));
    writeExrChannel<float>(path, wide, "Y", Imf::FLOAT);
    EXPECT_THAT(error(), EndsWith(": its primaries are other than those of sRGB"));

    Imf::Header tiled(4, 4);
    tiled.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    tiled.setTileDescription(Imf::TileDescription(4, 4));
    { const Imf::TiledOutputFile file(path.c_str(), tiled); }
    EXPECT_THAT(error(), EndsWith(": it is tiled or deep; only lines are read"));

    std::vector<Imf::Header> parts(2, Imf::Header(4, 4));
    for (std::size_t i = 0; i < 2; ++i) {
        parts[i].setName(i == 0 ? "left" : "right");
        parts[i].setType("scanlineimage");
        parts[i].channels().insert("Y", Imf::Channel(Imf::FLOAT));
    }
    { const Imf::MultiPartOutputFile file(path.c_str(), parts.data(), 2); }
    EXPECT_THAT(error(), EndsWith(": it has 2 parts; only one is read"));
}

}  // namespace
}  // namespace image
