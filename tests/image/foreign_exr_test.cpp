// OpenEXR files that other programs write: here its C++ library, which also reads grsh's.
#include "image/image_file.h"
#include "image/temporary_folder.h"
#include "support/error_of.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputPart.h>
#include <gmock/gmock.h>
#include <half.h>

namespace image {
namespace {

using support::errorOf;

using testing::ElementsAre;
using testing::EndsWith;
using testing::Pair;

// A number that half floats hold exactly, not far from those near it.
float numberOf(std::size_t pixel) {
    return 16 + float(pixel % 256) / 64;
}

// Parts, with the number of each pixel in each channel.
class ExrParts {
public:
    Imf::Header& add(const Imf::Header& header, const std::vector<std::string>& channels, Imf::PixelType type,
                     const std::string& kind = "scanlineimage") {
        Imf::Header& part = headers_.emplace_back(header);
        part.setType(kind);
        for (const std::string& name : channels) part.channels().insert(name, Imf::Channel(type));
        return part;
    }

    void write(const std::string& path) {
        if (headers_.size() > 1)
            for (std::size_t i = 0; i < headers_.size(); ++i) headers_[i].setName("part " + std::to_string(i));
        Imf::MultiPartOutputFile file(path.c_str(), headers_.data(), int(headers_.size()));
        for (std::size_t i = 0; i < headers_.size(); ++i) writePart(file, int(i), headers_[i]);
    }

private:
    template<class Number>
    static Imf::FrameBuffer bufferOf(const Imf::Header& header, std::vector<Number>& numbers) {
        const Imath::Box2i window = header.dataWindow();
        const std::size_t width = std::size_t(window.max.x - window.min.x + 1),
                          lines = std::size_t(window.max.y - window.min.y + 1);
        numbers.resize(width * lines);
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = Number(numberOf(i));
        Imf::FrameBuffer buffer;
        for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
            buffer.insert(channel.name(), Imf::Slice::Make(channel.channel().type, numbers.data(), window,
                                                           sizeof(Number), width * sizeof(Number)));
        return buffer;
    }

    static void writePart(Imf::MultiPartOutputFile& file, int number, const Imf::Header& header) {
        std::vector<half> halves;
        std::vector<float> floats;
        const bool isHalf = header.channels().begin().channel().type == Imf::HALF;
        const Imf::FrameBuffer buffer = isHalf ? bufferOf(header, halves) : bufferOf(header, floats);
        const Imath::Box2i window = header.dataWindow();
        if (!header.hasTileDescription()) {
            Imf::OutputPart part(file, number);
            part.setFrameBuffer(buffer);
            part.writePixels(window.max.y - window.min.y + 1);
            return;
        }
        Imf::TiledOutputPart part(file, number);
        part.setFrameBuffer(buffer);
        for (int y = 0; y < part.numYLevels(); ++y)
            for (int x = 0; x < part.numXLevels(); ++x)
                if (part.isValidLevel(x, y)) part.writeTiles(0, part.numXTiles(x) - 1, 0, part.numYTiles(y) - 1, x, y);
    }

    std::vector<Imf::Header> headers_;
};

const std::vector<float>& numbersOf(const Image& image, const std::string& channel) {
    return std::get<std::vector<float>>(image.find(channel)->samples);
}

// What each compression may lose, relative to a number.
double mostLost(Imf::Compression compression, Imf::PixelType type) {
    switch (compression) {
        case Imf::PXR24_COMPRESSION:
            return type == Imf::FLOAT ? 1. / 32768 : 0;
        case Imf::B44_COMPRESSION:
        case Imf::B44A_COMPRESSION:
            return type == Imf::HALF ? 0.03 : 0;
        case Imf::DWAA_COMPRESSION:
        case Imf::DWAB_COMPRESSION:
            return 0.03;
        default:
            return 0;
    }
}

void expectNumbers(const std::vector<float>& numbers, double most, const std::string& what) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const float expected = numberOf(i);
        ASSERT_LE(std::abs(numbers[i] - expected), most * expected) << what << ", pixel " << i;
    }
}

// Two parts or one, lines from the top or from the bottom, and tiles of every kind.
TEST(ForeignExr, OfEveryCompressionIsRead) {
    const TemporaryFolder folder;
    const std::string path = folder / "a.exr";
    for (int i = 0; i < Imf::NUM_COMPRESSION_METHODS; ++i) {
        const auto compression = static_cast<Imf::Compression>(i);
        for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
            for (const std::string kind : {"increasing", "decreasing", "one level", "mipmap", "ripmap", "parts"}) {
                const std::string what = std::to_string(i) + (type == Imf::HALF ? " half " : " float ") + kind;
                Imf::Header header(40, 60, {{-2, -3}, {30, 41}}, 1, {0, 0}, 1,
                                   kind == "decreasing" ? Imf::DECREASING_Y : Imf::INCREASING_Y, compression);
                ExrParts parts;
                if (kind == "parts") parts.add(header, {"Z"}, Imf::FLOAT);
                const auto mode = kind == "mipmap"   ? Imf::MIPMAP_LEVELS
                                  : kind == "ripmap" ? Imf::RIPMAP_LEVELS
                                                     : Imf::ONE_LEVEL;
                const bool isTiled = kind == "one level" || mode != Imf::ONE_LEVEL;
                if (isTiled) header.setTileDescription(Imf::TileDescription(13, 9, mode));
                parts.add(header, {"R", "G", "B"}, type, isTiled ? "tiledimage" : "scanlineimage");
                parts.write(path);
                const Image image = readImage(path);
                EXPECT_EQ(image.held, (Window{-2, -3, 33, 45})) << what;
                EXPECT_EQ(image.whole, (Window{0, 0, 40, 60})) << what;
                EXPECT_EQ(image.channelNames(), "B G R") << what;
                EXPECT_EQ(image.partsLeftOut, kind == "parts" ? 1 : 0) << what;
                for (const char* channel : {"R", "G", "B"})
                    expectNumbers(numbersOf(image, channel), mostLost(compression, type), what);
            }
        }
    }
}

// A file may be a tile, and small: what reading it takes is not told by its size.
TEST(ForeignExr, OfOneLargeTileIsRead) {
    const TemporaryFolder folder;
    Imf::Header header(2500, 2500, 1, {0, 0}, 1, Imf::INCREASING_Y, Imf::ZIP_COMPRESSION);
    header.setTileDescription(Imf::TileDescription(2500, 2500));
    ExrParts parts;
    parts.add(header, {"R", "G", "B"}, Imf::FLOAT, "tiledimage");
    parts.write(folder / "a.exr");
    EXPECT_LT(bytesOf(folder / "a.exr").size(), 4'000'000u);
    const Image image = readImage(folder / "a.exr");
    for (const char* channel : {"R", "G", "B"}) expectNumbers(numbersOf(image, channel), 0, channel);
}

// Of half floats beside floats each line has first all of one channel, and then all of the next.
TEST(ForeignExr, OfHalfFloatsBesideFloatsIsRead) {
    const TemporaryFolder folder;
    for (const auto compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION}) {
        constexpr int width = 7, height = 37;
        Imf::Header header(width, height, 1, {0, 0}, 1, Imf::INCREASING_Y, compression);
        std::vector<float> floats(width * height);
        std::vector<half> halves(width * height);
        for (std::size_t i = 0; i < floats.size(); ++i) {
            floats[i] = -1.f / (1 + float(i));
            halves[i] = numberOf(i);
        }
        Imf::FrameBuffer buffer;
        const auto add = [&]<class Number>(const char* name, Imf::PixelType type, std::vector<Number>& numbers) {
            header.channels().insert(name, Imf::Channel(type));
            buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(numbers.data()), sizeof(Number),
                                           width * sizeof(Number)));
        };
        add("A", Imf::HALF, halves);
        add("B", Imf::FLOAT, floats);
        add("C", Imf::HALF, halves);
        {
            Imf::OutputFile file((folder / "a.exr").c_str(), header);
            file.setFrameBuffer(buffer);
            file.writePixels(height);
        }
        const Image image = readImage(folder / "a.exr");
        EXPECT_EQ(numbersOf(image, "B"), floats) << compression;
        for (const char* channel : {"A", "C"})
            EXPECT_EQ(numbersOf(image, channel), std::vector<float>(halves.begin(), halves.end())) << compression;
    }
}

// As B44 keeps them: in blocks of 4 x 4 pixels, of which the last ones are cut off.
TEST(ForeignExr, OfBlocksThatAreCutOffIsRead) {
    const TemporaryFolder folder;
    for (const auto compression : {Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION}) {
        ExrParts parts;
        parts.add(Imf::Header(33, 33, 1, {0, 0}, 1, Imf::INCREASING_Y, compression), {"Y"}, Imf::HALF);
        parts.write(folder / "a.exr");
        expectNumbers(numbersOf(readImage(folder / "a.exr"), "Y"), 0.03, "33 x 33");
    }
}

TEST(ForeignExr, OfManyPartsIsItsFirstPicture) {
    const TemporaryFolder folder;
    const std::string path = folder / "a.exr";
    ExrParts parts;
    // All show the same frame.
    const auto ofWidth = [](int width) { return Imf::Header(9, 4, {{0, 0}, {width - 1, 3}}); };
    parts.add(ofWidth(4), {"id"}, Imf::UINT);
    parts.add(ofWidth(5), {"albedo.R"}, Imf::FLOAT);
    parts.add(ofWidth(6), {"Y", "A"}, Imf::HALF);
    parts.add(ofWidth(7), {"R", "G", "B"}, Imf::HALF);
    parts.write(path);
    Image image = readImage(path);
    EXPECT_EQ(image.held.width, 6);
    EXPECT_EQ(image.channelNames(), "A Y");
    EXPECT_EQ(image.partsLeftOut, 3);
    EXPECT_THAT(image.metadata, ElementsAre(Pair("name", "part 2")));
    EXPECT_THAT(errorOf([&] { ImageFile(folder / "b.exr").write(image); }),
                EndsWith("cannot write \"" + (folder / "b.exr") +
                         "\": what it is made from has 4 parts, of which all but one would be lost"));
    // Without any, the first one.
    ExrParts layers;
    layers.add(ofWidth(5), {"Z"}, Imf::FLOAT);
    layers.add(ofWidth(6), {"N"}, Imf::FLOAT);
    layers.write(path);
    EXPECT_EQ(readImage(path).channelNames(), "Z");
}

// Texts keep their order and names of more than 31 letters, also when they are written again.
TEST(ForeignExr, KeepsItsTexts) {
    const TemporaryFolder folder;
    const std::string name = "a name of more than thirty-one letters",
                      layer = "a layer of more than thirty-one letters.R";
    ExrParts parts;
    Imf::Header& header = parts.add(Imf::Header(2, 2), {layer, "R", "G", "B"}, Imf::FLOAT);
    header.insert(name, Imf::StringAttribute("of value"));
    header.insert("owner", Imf::StringAttribute(""));
    parts.write(folder / "a.exr");
    const Image image = readImage(folder / "a.exr");
    EXPECT_THAT(image.metadata, ElementsAre(Pair(name, "of value"), Pair("owner", "")));
    ImageFile(folder / "b.exr").write(image);
    const Image again = readImage(folder / "b.exr");
    EXPECT_EQ(again.metadata, image.metadata);
    EXPECT_EQ(again.channelNames(), "B G R " + layer);
    Image tooLong = image;
    tooLong.metadata.emplace_back(std::string(256, 'x'), "");
    EXPECT_THAT(errorOf([&] { ImageFile(folder / "c.exr").write(tooLong); }),
                EndsWith(": the name \"" + std::string(31, 'x') + "...\" has more than 255 letters"));
}

// The library's own blur of chroma keeps what changes slowly.
TEST(ForeignExr, OfLuminanceAndChromaBecomesColours) {
    const TemporaryFolder folder;
    const std::string path = folder / "a.exr";
    constexpr int width = 64, height = 48;
    const auto colour = [](int x, int y) {
        return Imf::Rgba(1 + float(x) / 128, 1 + float(y) / 128, 2 - float(x + y) / 128, 0.5f);
    };
    for (const auto channels : {Imf::WRITE_YC, Imf::WRITE_YCA}) {
        Imf::Array2D<Imf::Rgba> pixels(height, width);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) pixels[y][x] = colour(x, y);
        {
            Imf::RgbaOutputFile file(path.c_str(), width, height, channels);
            file.setFrameBuffer(&pixels[0][0], 1, width);
            file.writePixels(height);
        }
        const Image image = readImage(path);
        ASSERT_EQ(image.channelNames(), channels == Imf::WRITE_YC ? "B G R" : "A B G R");
        for (std::size_t i = 0; i < image.pixels(); ++i) {
            const int x = int(i) % width, y = int(i) / width;
            // The blur goes beyond the edges.
            const bool isInside = x >= 16 && x < width - 16 && y >= 16 && y < height - 16;
            const double most = isInside ? 0.015 : 0.1;
            const Imf::Rgba expected = colour(x, y);
            ASSERT_NEAR(numbersOf(image, "R")[i], expected.r, most) << x << " " << y;
            ASSERT_NEAR(numbersOf(image, "G")[i], expected.g, most) << x << " " << y;
            ASSERT_NEAR(numbersOf(image, "B")[i], expected.b, most) << x << " " << y;
            if (channels == Imf::WRITE_YCA) {
                ASSERT_EQ(numbersOf(image, "A")[i], 0.5f);
            }
        }
    }
}

class ForeignExrError : public testing::Test {
protected:
    std::string error() {
        const std::string text = errorOf([&] { readImage(path_); });
        const std::string words = "cannot read \"" + path_ + "\": ";
        const std::size_t found = text.find(words);
        return found == std::string::npos ? text : text.substr(found + words.size());
    }
    std::string errorOfParts(ExrParts parts) {
        parts.write(path_);
        return error();
    }

    TemporaryFolder folder_;
    std::string path_ = folder_ / "a.exr";
};

TEST_F(ForeignExrError, NamesTheChannel) {
    ExrParts whole;
    whole.add(Imf::Header(4, 4), {"id"}, Imf::UINT);
    EXPECT_EQ(errorOfParts(whole), "its channel \"id\" holds whole numbers");
    Imf::Header header(4, 4);
    header.channels().insert("Y", Imf::Channel(Imf::HALF));
    header.channels().insert("RY", Imf::Channel(Imf::HALF, 2, 2));
    Imf::MultiPartOutputFile(path_.c_str(), &(header.setType("scanlineimage"), header), 1);
    EXPECT_EQ(error(), "its channel \"RY\" does not have a number for each pixel");
}

TEST_F(ForeignExrError, NamesThePrimaries) {
    Imf::Header wide(4, 4);
    Imf::addChromaticities(wide,
                           Imf::Chromaticities({0.7347f, 0.2653f}, {0, 1}, {0.0001f, -0.077f}, {0.32168f, 0.33767f}));
    ExrParts aces;
    aces.add(wide, {"Y"}, Imf::FLOAT);
    EXPECT_EQ(errorOfParts(aces), "its primaries are those of ACES (AP0), not of sRGB");
    Imf::addChromaticities(wide, Imf::Chromaticities());
    ExrParts srgb;
    srgb.add(wide, {"Y"}, Imf::FLOAT);
    EXPECT_EQ(errorOfParts(srgb), "no error");
}

TEST_F(ForeignExrError, TellsOfDeepPictures) {
    Imf::Header deep(4, 4);
    deep.setType("deepscanline");
    deep.compression() = Imf::ZIPS_COMPRESSION;
    deep.channels().insert("R", Imf::Channel(Imf::FLOAT));
    { const Imf::MultiPartOutputFile file(path_.c_str(), &deep, 1); }
    EXPECT_EQ(error(), "it is deep: each of its pixels may have many numbers; only flat pictures are read");
}

// A picture whose writing was broken off has no place yet where its lines are.
TEST_F(ForeignExrError, TellsOfWhatIsNotThere) {
    Imf::Header header(4, 4);
    header.setType("scanlineimage");
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.compression() = Imf::ZIP_COMPRESSION;
    { const Imf::MultiPartOutputFile file(path_.c_str(), &header, 1); }
    EXPECT_EQ(error(), "it is not complete: its table does not say where all of its pixels are");
    ExrParts parts;
    parts.add(header, {"Y"}, Imf::FLOAT);
    parts.write(path_);
    const std::string bytes = bytesOf(path_);
    writeText(path_, bytes.substr(0, bytes.size() - 1));
    EXPECT_EQ(error(), "it ends too early");
    writeText(path_, bytes.substr(0, 100));
    EXPECT_EQ(error(), "it ends too early");
    // A text that says that it has 2 GB.
    std::string changed = bytes;
    changed.replace(changed.find("string") + 7, 4, "\xff\xff\xff\x7f");
    writeText(path_, changed);
    EXPECT_EQ(error(), "it ends too early");
    // 30000 x 30000 pixels, of which a tile is all.
    Imf::Header huge(30000, 30000);
    huge.setType("tiledimage");
    huge.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    huge.setTileDescription(Imf::TileDescription(30000, 30000));
    { const Imf::MultiPartOutputFile file(path_.c_str(), &huge, 1); }
    EXPECT_EQ(error(), "it announces 30000 x 30000 pixels and has " + std::to_string(bytesOf(path_).size()) + " bytes");
}

}  // namespace
}  // namespace image
