// Radiance's pictures, byte by byte.
#include "image/image_file.h"
#include "image/temporary_folder.h"
#include "support/error_of.h"

#include <gmock/gmock.h>

namespace image {
namespace {

using support::errorOf;

using testing::ElementsAre;
using testing::ElementsAreArray;

const std::string start = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n";

class HdrReader : public testing::Test {
protected:
    Image read(const std::string& bytes) {
        writeText(folder_ / "a.hdr", bytes);
        return readImage(folder_ / "a.hdr");
    }
    std::vector<float> numbers(const std::string& bytes, const char* channel) {
        return std::get<std::vector<float>>(read(bytes).find(channel)->samples);
    }
    std::string error(const std::string& bytes) {
        const std::string text = errorOf([&] { read(bytes); });
        const std::string words = "cannot read \"" + (folder_ / "a.hdr") + "\": ";
        const std::size_t found = text.find(words);
        return found == std::string::npos ? text : text.substr(found + words.size());
    }

    TemporaryFolder folder_;
};

// A mantissa stands for the middle of its step: (128 + 0.5)/256 * 2^1 is 1.00390625.
TEST_F(HdrReader, ReadsMantissasAndExponents) {
    const std::string pixels = std::string("\x80\x40\x20\x81\x01\x02\x03\0\xff\0\0\x78", 12);
    const std::string file = start + "\n-Y 1 +X 3\n" + pixels;
    EXPECT_THAT(numbers(file, "R"), ElementsAre(1.00390625f, 0, 255.5f / 65536));
    EXPECT_THAT(numbers(file, "G"), ElementsAre(0.50390625f, 0, 0.5f / 65536));
    EXPECT_THAT(numbers(file, "B"), ElementsAre(0.25390625f, 0, 0.5f / 65536));
}

TEST_F(HdrReader, TakesBackWhatTheNumbersWereMultipliedBy) {
    const std::string pixel = "\x80\x80\x80\x81";
    const std::string file = start + "EXPOSURE=2\nEXPOSURE= 0.25 \nCOLORCORR=1 2 4\n\n-Y 1 +X 1\n" + pixel;
    EXPECT_THAT(numbers(file, "R"), ElementsAre(2.0078125f));
    EXPECT_THAT(numbers(file, "G"), ElementsAre(1.00390625f));
    EXPECT_THAT(numbers(file, "B"), ElementsAre(0.501953125f));
}

// Pixels 1 to 6 of three by two, as they come in the file.
TEST_F(HdrReader, ReadsFromWhateverCorner) {
    std::string pixels;
    for (char i = 1; i <= 6; ++i) pixels += std::string{i, 8, 8, char(0x88)};
    const auto order = [&](const std::string& axes) {
        std::vector<int> places;
        for (const float number : numbers(start + "\n" + axes + "\n" + pixels, "R")) places.push_back(int(number));
        return places;
    };
    EXPECT_THAT(order("-Y 2 +X 3"), ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_THAT(order("-Y 2 -X 3"), ElementsAre(3, 2, 1, 6, 5, 4));
    EXPECT_THAT(order("+Y 2 +X 3"), ElementsAre(4, 5, 6, 1, 2, 3));
    EXPECT_THAT(order("+Y 2 -X 3"), ElementsAre(6, 5, 4, 3, 2, 1));
    EXPECT_THAT(order("+X 3 -Y 2"), ElementsAre(1, 3, 5, 2, 4, 6));
    EXPECT_THAT(order("-X 3 -Y 2"), ElementsAre(5, 3, 1, 6, 4, 2));
    EXPECT_THAT(order("+X 3 +Y 2"), ElementsAre(2, 4, 6, 1, 3, 5));
    EXPECT_THAT(order("-X 3 +Y 2"), ElementsAre(6, 4, 2, 5, 3, 1));
    EXPECT_EQ(read(start + "\n+X 3 -Y 2\n" + pixels).held, (Window{0, 0, 3, 2}));
}

// Runs of pixels: once three, and 256 + 2 by two in a row.
TEST_F(HdrReader, ReadsRunsOfPixels) {
    const std::string pixel = "\x05\x08\x08\x88", other = "\x07\x08\x08\x88";
    const std::string file = start + "\n-Y 1 +X 263\n" + pixel + "\1\1\1\3" + other + "\1\1\1\2\1\1\1\1";
    std::vector<float> expected(263, 7.5f);
    std::fill_n(expected.begin(), 4, 5.5f);
    EXPECT_THAT(numbers(file, "R"), ElementsAreArray(expected));
    EXPECT_EQ(error(start + "\n-Y 1 +X 2\n" + pixel + "\1\1\1\2"), "its pixels go beyond the end of a line");
    EXPECT_EQ(error(start + "\n-Y 1 +X 2\n\1\1\1\1" + pixel), "its first pixel of a line repeats one before it");
}

TEST_F(HdrReader, ReadsRunsOfBytes) {
    const std::string head = start + "\n-Y 1 +X 9\n" + std::string("\2\2\0\x09", 4);
    const std::string red = std::string("\x84\x05\5\1\2\3\4\6", 8), same = "\x89\x08", exponent = "\x89\x88";
    EXPECT_THAT(numbers(head + red + same + same + exponent, "R"),
                ElementsAre(5.5f, 5.5f, 5.5f, 5.5f, 1.5f, 2.5f, 3.5f, 4.5f, 6.5f));
    EXPECT_EQ(error(head + "\x8a\x08" + same + same + exponent), "its bytes go beyond the end of a line");
    EXPECT_EQ(error(head + std::string("\0\x08", 2) + same + same + exponent), "its bytes go beyond the end of a line");
    EXPECT_EQ(error(head + red + same + same), "it ends too early");
    EXPECT_EQ(error(start + "\n-Y 1 +X 9\n" + std::string("\2\2\0\x08", 4) + red),
              "its lines are not as long as it announces");
}

TEST_F(HdrReader, SaysWhatIsWrong) {
    const std::string pixel = "\x80\x40\x20\x81", end = "\n-Y 1 +X 1\n" + pixel;
    EXPECT_EQ(error(start + end), "no error");
    EXPECT_EQ(error("#?RGBE\n" + end), "no error");
    EXPECT_EQ(error("P6 1 1"), "it is no picture of Radiance: it does not begin with #?");
    EXPECT_EQ(error("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n" + end),
              "its colours are those of CIE XYZ, not those of sRGB");
    EXPECT_EQ(error("#?RADIANCE\nFORMAT=other\n" + end), "its FORMAT is \"other\", not \"32-bit_rle_rgbe\"");
    EXPECT_EQ(error(start + "PRIMARIES=.64 .33 .3 .6 .15 .06 .3127 .329\n" + end), "no error");
    EXPECT_EQ(error(start + "PRIMARIES=.64 .33 .29 .6 .15 .06 .3333 .3333\n" + end),
              "its primaries are those of Radiance, not of sRGB");
    EXPECT_EQ(error(start + "PRIMARIES=.64 .33\n" + end), "its PRIMARIES has not 8 numbers: \".64 .33\"");
    EXPECT_EQ(error(start + "EXPOSURE=0\n" + end), "its EXPOSURE is not above 0");
    EXPECT_EQ(error(start + "\n-Y 1 +Y 1\n" + pixel),
              "its line of axes is \"-Y 1 +Y 1\", not one like \"-Y 480 +X 640\"");
    EXPECT_EQ(error(start + "\n-Y 1 +X 1 2\n" + pixel),
              "its line of axes is \"-Y 1 +X 1 2\", not one like \"-Y 480 +X 640\"");
    EXPECT_EQ(error(start + "\n-Y 0 +X 1\n" + pixel), "its size is not from 1 to 1000000 pixels");
    EXPECT_EQ(error(start + "\n-Y 30000 +X 30000\n" + pixel), "it announces 30000 x 30000 pixels and has 72 bytes");
    EXPECT_EQ(error(start), "it ends too early");
    EXPECT_THAT(error(start + std::string(10'001, 'x')), "its header has a line of more than 10000 letters");
}

TEST_F(HdrReader, IsNotWrittenButMakesFloats) {
    writeText(folder_ / "a.hdr", start + "\n-Y 1 +X 1\n\x80\x40\x20\x81");
    const auto check = [&](const std::string& name) {
        return errorOf([&] { ImageFile(folder_ / name).checkAgainst(folder_ / "a.hdr"); });
    };
    EXPECT_EQ(check("b.exr"), "no error");
    EXPECT_EQ(check("b.pfm"), "no error");
    EXPECT_EQ(check("b.png"), "FILE ENDING [" + (folder_ / "b.png") + "] cannot write \"" + (folder_ / "b.png") +
                                  "\": its ending must be .exr or .pfm, as \"" + (folder_ / "a.hdr") +
                                  "\" has floats and its format is not written");
    EXPECT_EQ(check("b.hdr"), "FILE ENDING [" + (folder_ / "b.hdr") + "] cannot write \"" + (folder_ / "b.hdr") +
                                  "\": the file's ending must be .png, .exr or .pfm");
}

}  // namespace
}  // namespace image
