// Reading what grsh writes: the numbers, the place and the texts.
#include "image/image_file.h"
#include "image/image_samples.h"
#include "image/png_reader.h"
#include "image/temporary_folder.h"
#include "support/error_of.h"

#include <gmock/gmock.h>

namespace image {
namespace {

using support::errorOf;

using testing::ElementsAre;
using testing::Pair;

const Metadata texts{{"Software", "grsh 1"}, {"Scene", "b\xc3\xbchne.gr"}, {"grsh:lights", ""}, {"grsh:seed", "7"}};

void expectSame(const Image& a, const Image& b) {
    EXPECT_EQ(a.held, b.held);
    EXPECT_EQ(a.whole, b.whole);
    EXPECT_EQ(a.isPart, b.isPart);
    EXPECT_EQ(a.metadata, b.metadata);
    ASSERT_EQ(a.channelNames(), b.channelNames());
    for (std::size_t c = 0; c < a.channels.size(); ++c) EXPECT_EQ(a.channels[c].samples, b.channels[c].samples) << c;
}

Image rewritten(const Image& image, const std::string& name) {
    const TemporaryFolder folder;
    ImageFile(folder / name).write(image);
    EXPECT_THAT(folder.names(), ElementsAre(name));
    return readImage(folder / name);
}

TEST(ImageReader, ReadsEveryKindOfPngThatIsWritten) {
    for (const std::string_view channels : {"Y", "YA", "RGB", "RGBA"}) {
        for (const auto& [width, height] : {std::pair(1, 1), {7, 5}, {300, 2}}) {
            Image shallow = randomImage<std::uint8_t>(width, height, channels);
            Image deep = randomImage<std::uint16_t>(width, height, channels);
            shallow.metadata = deep.metadata = texts;
            expectSame(rewritten(shallow, "a.png"), shallow);
            expectSame(rewritten(deep, "a.PNG"), deep);
        }
    }
}

TEST(ImageReader, ReadsFloats) {
    Image image = randomImage<float>(33, 40, "ABGRZ");
    image.metadata = texts;
    image.held.left = -3;
    image.held.top = 17;
    image.whole = {-10, -20, 100, 90};
    image.isPart = true;
    auto& numbers = std::get<std::vector<float>>(image.channels[2].samples);
    numbers[5] = core::infinity;
    numbers[6] = -0.f;
    numbers[7] = 1e-45f;
    expectSame(rewritten(image, "a.exr"), image);
    for (const std::string_view channels : {"RGB", "Y"}) {
        const Image plain = randomImage<float>(9, 4, channels);
        expectSame(rewritten(plain, "a.pfm"), plain);
    }
}

// The numbers and the texts of a render, and where its strips belong.
TEST(ImageReader, ReadsWhatARenderWrites) {
    const TemporaryFolder folder;
    Film film(5, 30, 10, 4, everyLayer);
    for (int y = 10; y < 14; ++y)
        for (int x = 0; x < 5; ++x) film.at(x, y) = core::Rgbf(float(x), float(y), 0.25f);
    film.at(Layer::depth, 3, 12)[0] = 8.5f;
    for (const char* name : {"a.png", "a.exr", "a.pfm"}) ImageFile(folder / name).write(film, -4, texts);
    const Image png = readImage(folder / "a.png"), exr = readImage(folder / "a.exr"), pfm = readImage(folder / "a.pfm");
    EXPECT_EQ(png.held, (Window{0, 10, 5, 4}));
    EXPECT_TRUE(png.isPart);
    EXPECT_EQ(exr.held, (Window{0, 10, 5, 4}));
    EXPECT_EQ(exr.whole, (Window{0, 0, 5, 30}));
    EXPECT_TRUE(exr.isPart);
    EXPECT_EQ(pfm.held, (Window{0, 0, 5, 4}));
    EXPECT_EQ(png.metadata, texts);
    EXPECT_EQ(exr.metadata, texts);
    EXPECT_EQ(png.channelNames(), "R G B");
    EXPECT_EQ(exr.channels.size(), 14u);
    for (std::size_t i = 0; i < 20; ++i) {
        const int x = int(i % 5), y = 10 + int(i / 5);
        EXPECT_EQ(std::get<0>(png.find("G")->samples)[i], toByte(Curve::srgb, float(y) / 16));
        EXPECT_EQ(std::get<2>(exr.find("R")->samples)[i], float(x));
        EXPECT_EQ(std::get<2>(exr.find("Z")->samples)[i], i == 13 ? 8.5f : 0);
        EXPECT_EQ(std::get<2>(pfm.find("G")->samples)[i], float(y));
    }
    // Written again they are the same to the byte.
    for (const char* name : {"a.png", "a.exr", "a.pfm"}) {
        const std::string bytes = bytesOf(folder / name);
        ImageFile(folder / name).write(readImage(folder / name));
        EXPECT_TRUE(bytesOf(folder / name) == bytes) << name;
    }
}

TEST(ImageReader, DecodesWhatItEncodes) {
    for (int i = 0; i < 256; ++i) EXPECT_EQ(toByte(Curve::srgb, static_cast<float>(decodeSrgb(i / 255.))), i);
    for (double x = 0; x <= 1; x += 1. / 512) EXPECT_NEAR(encodeSrgb(decodeSrgb(x)), x, 1e-7);
    EXPECT_NEAR(decodeSrgb(0.5), 0.21404114, 1e-8);
}

// Every beginning of a file, and every file with one byte changed: an error that names it, or a picture.
TEST(ImageReader, RefusesWhatIsNotWholeOrNotTheFormat) {
    const TemporaryFolder folder;
    Image floats = randomImage<float>(6, 20, "BGR");
    Image bytes = randomImage<std::uint8_t>(6, 20, "RGB");
    floats.metadata = bytes.metadata = texts;
    for (const std::string name : {"a.png", "a.exr", "a.pfm"}) {
        const std::string path = folder / name;
        ImageFile(path).write(name == "a.png" ? bytes : floats);
        const std::string whole = bytesOf(path);
        // A process for each .exr takes its time.
        const std::size_t step = name == "a.exr" ? 5 : 1;
        for (std::size_t length = 0; length < whole.size(); length += step) {
            writeText(path, whole.substr(0, length));
            EXPECT_THAT(errorOf([&] { readImage(path); }),
                        testing::StartsWith("FILE READ [" + path + "] cannot read \"" + path + "\": "))
                << length;
        }
        int refused = 0;
        for (std::size_t i = 0; i < whole.size(); i += step) {
            std::string changed = whole;
            changed[i] = static_cast<char>(changed[i] ^ 0x80);
            writeText(path, changed);
            const std::string error = errorOf([&] { readImage(path); });
            if (error == "no error") continue;
            ++refused;
            EXPECT_THAT(error, testing::HasSubstr("cannot read \"" + path + "\": ")) << i;
        }
        EXPECT_GT(refused, name == "a.png" ? 150 : name == "a.exr" ? 30 : 5) << name;
        writeText(path, whole);
        EXPECT_EQ(errorOf([&] { readImage(path); }), "no error");
    }
}

TEST(ImageReader, SaysWhatIsWrong) {
    const TemporaryFolder folder;
    const auto error = [&](const std::string& name) {
        const std::string text = errorOf([&] { readImage(folder / name); });
        const std::string start = "FILE READ [" + (folder / name) + "] cannot read \"" + (folder / name) + "\": ";
        return text.starts_with(start) ? text.substr(start.size()) : text;
    };
    EXPECT_EQ(error("none.png"), "No such file or directory");
    std::filesystem::create_directory(folder / "folder.png");
    EXPECT_EQ(error("folder.png"), "it is not a file");
    for (const std::string name : {"a.png", "a.exr", "a.pfm"})
        writeText(folder / name, "something else, and long enough");
    EXPECT_EQ(error("a.png"), "libpng: Not a PNG file");
    EXPECT_EQ(error("a.exr"), "it is no OpenEXR file: it does not begin with the bytes 76 2F 31 01");
    EXPECT_EQ(error("a.pfm"), "it is no portable float map: it does not begin with PF or Pf");
    writeText(folder / "a.pfm", "PF\n0 2\n-1\n");
    EXPECT_EQ(error("a.pfm"), "its header says 0 x 2 pixels");
    writeText(folder / "a.pfm", "Pf\n1 1\n0\nabcd");
    EXPECT_EQ(error("a.pfm"), "its header's scale is 0 or not finite");
    writeText(folder / "a.pfm", "Pf\n1 1 -1xabcd");
    EXPECT_EQ(error("a.pfm"), "its header is broken");
    writeText(folder / "a.pfm", "Pf\n1 1\n-1\nabcde");
    EXPECT_EQ(error("a.pfm"), "it goes on behind its last pixel");
    writeText(folder / "a.pfm", "Pf\n1 1\n-1\nabc");
    EXPECT_EQ(error("a.pfm"), "it announces 1 x 1 pixels and has 13 bytes");
    writeText(folder / "a.pfm", "PF\n1000000 1000000\n-1\nabc");
    EXPECT_EQ(error("a.pfm"), "it announces 1000000 x 1000000 pixels and has 25 bytes");
    EXPECT_THAT(errorOf([&] {
                    checkMemory({0, 0, 1'000'000, 1'000'000}, 12);
                }),
                testing::HasSubstr("a picture of 1000000 x 1000000 pixels takes 11 TB of memory; "));
    EXPECT_EQ(errorOf([&] { readImage("a.jpg"); }),
              "FILE ENDING [a.jpg] cannot read \"a.jpg\": the file's ending must be .png, .exr, .pfm, .hdr or .pic");
}

TEST(ImageReader, ReadsEitherByteOrderAndTheScaleOfAPfm) {
    const TemporaryFolder folder;
    // 1.5 and -2, the lower line first.
    writeText(folder / "big.pfm", std::string("Pf\n1 2\n1.0\n\xc0\0\0\0\x3f\xc0\0\0", 19));
    writeText(folder / "half.pfm", std::string("Pf 1 2 -0.5\t\0\0\0\xc0\0\0\xc0\x3f", 20));
    EXPECT_THAT(std::get<2>(readImage(folder / "big.pfm").channels.at(0).samples), ElementsAre(1.5f, -2));
    EXPECT_THAT(std::get<2>(readImage(folder / "half.pfm").channels.at(0).samples), ElementsAre(0.75f, -1));
}

TEST(ImageWriting, LeavesWhatWasThereWhenTheDiskIsFull) {
    const TemporaryFolder folder;
    for (const std::string name : {"a.png", "a.exr", "a.pfm"}) {
        writeText(folder / name, "as it was");
        const ImageFile file(folder / name);
        const Image image =
            name == "a.png" ? randomImage<std::uint8_t>(90, 90, "RGB") : randomImage<float>(90, 90, "BGR");
        std::string error;
        {
            const FullDisk disk(5000);
            error = errorOf([&] { file.write(image); });
        }
        EXPECT_THAT(error, testing::HasSubstr("cannot write \"" + (folder / name) + "\": ")) << name;
        EXPECT_EQ(bytesOf(folder / name), "as it was");
    }
    EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("a.png", "a.exr", "a.pfm"));
}

TEST(ImageFileCheck, NeverWritesOverWhatItReads) {
    const TemporaryFolder folder;
    writeText(folder / "a.png", "a");
    writeText(folder / "b.exr", "b");
    std::filesystem::create_symlink(folder / "a.png", folder / "link.png");
    std::filesystem::create_hard_link(folder / "a.png", folder / "hard.png");
    for (const std::string name : {"a.png", "link.png", "hard.png", "./a.png"})
        EXPECT_EQ(errorOf([&] { ImageFile(folder / name).checkAgainst(folder / "a.png"); }),
                  "FILE SAME [" + (folder / name) + "] cannot write \"" + (folder / name) +
                      "\": it is the same file as \"" + (folder / "a.png") + "\"");
    EXPECT_EQ(errorOf([&] { ImageFile(folder / "c.png").checkAgainst(folder / "b.exr"); }),
              "FILE ENDING [" + (folder / "c.png") + "] cannot write \"" + (folder / "c.png") +
                  "\": its ending must be .exr, that of \"" + (folder / "b.exr") + "\"");
    EXPECT_EQ(errorOf([&] { ImageFile(folder / "c.PNG").checkAgainst(folder / "a.png"); }), "no error");
    EXPECT_EQ(errorOf([&] { ImageFile(folder / "c.png").checkIsNot(folder / "b.exr"); }), "no error");
}

}  // namespace
}  // namespace image
