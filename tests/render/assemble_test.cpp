// Strips put together, and those that do not belong together.
#include "render/accumulate/assemble.h"

#include "image/image_samples.h"
#include "image/temporary_folder.h"
#include "render/accumulate/noise.h"
#include "render/grsh_process.h"
#include "support/error_of.h"

#include <gmock/gmock.h>

namespace render {
using namespace image;
namespace {

using support::errorOf;

// Lines first to last of a picture of 3 x 10 pixels whose samples are their own line's number.
Strip strip(const std::string& path, int first, int last) {
    image::Image image = randomImage<std::uint8_t>(3, last - first + 1, "RGB");
    image.held.top = first;
    image.whole = {0, 0, 3, 10};
    image.isPart = true;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < image.pixels(); ++i)
            std::get<0>(image.channels[c].samples)[i] =
                static_cast<std::uint8_t>(first + int(i) / 3 + 100 * int(c == 2));
    image.metadata = {{"Scene", "a.gr"},
                      {"grsh:width", "3"},
                      {"grsh:height", "10"},
                      {"grsh:startline", std::to_string(first)},
                      {"grsh:stopline", std::to_string(last)},
                      {"grsh:samplesperpixel", "4"},
                      {"grsh:seed", "5"}};
    return {path, image};
}

std::string errorOfStrips(std::vector<Strip> strips) {
    return errorOf([&] { assemble(std::move(strips)); });
}

TEST(Assemble, PutsTheLinesInTheirPlaces) {
    const image::Image whole = assemble({strip("c", 4, 4), strip("a", 5, 9), strip("b", 0, 3)});
    EXPECT_EQ(whole.held, (image::Window{0, 0, 3, 10}));
    EXPECT_EQ(whole.whole, (image::Window{0, 0, 3, 10}));
    EXPECT_FALSE(whole.isPart);
    for (std::size_t i = 0; i < 30; ++i) {
        EXPECT_EQ(std::get<0>(whole.channels[0].samples)[i], i / 3);
        EXPECT_EQ(std::get<0>(whole.channels[2].samples)[i], 100 + i / 3);
    }
    EXPECT_EQ(whole.metadata, strip("", 0, 9).image.metadata);
}

TEST(Assemble, RefusesLinesThatNoneHasOrTwoHave) {
    EXPECT_EQ(errorOfStrips({strip("a", 0, 3), strip("b", 5, 9)}),
              "STRIP GAP [a] no strip has line 4, between \"a\" and \"b\"");
    EXPECT_EQ(errorOfStrips({strip("b", 7, 9), strip("a", 2, 6)}),
              "STRIP GAP [a] no strip has lines 0 to 1, between the top and \"a\"");
    EXPECT_EQ(errorOfStrips({strip("a", 0, 7)}),
              "STRIP GAP [a] no strip has lines 8 to 9, between \"a\" and the bottom");
    EXPECT_EQ(errorOfStrips({strip("a", 0, 5), strip("b", 4, 9)}),
              "STRIP OVERLAP [b] \"a\" and \"b\" both have lines 4 to 5");
    EXPECT_EQ(errorOfStrips({strip("a", 0, 9), strip("b", 4, 4)}),
              "STRIP OVERLAP [b] \"a\" and \"b\" both have line 4");
    EXPECT_EQ(errorOfStrips({strip("a", 0, 4), strip("b", 5, 9), strip("c", 5, 9)}),
              "STRIP OVERLAP [c] \"b\" and \"c\" both have lines 5 to 9");
}

// Columns left to right of the lines of a strip, and their numbers in its samples' second channel.
Strip block(const std::string& path, int first, int last, int left, int right) {
    const Strip lines = strip(path, first, last);
    Strip block = lines;
    const int width = right - left + 1;
    block.image.held = {left, first, width, last - first + 1};
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<std::uint8_t> numbers;
        for (int y = 0; y < block.image.held.height; ++y)
            for (int x = left; x <= right; ++x)
                numbers.push_back(c == 1
                                      ? static_cast<std::uint8_t>(x)
                                      : std::get<0>(lines.image.channels[c].samples)[static_cast<std::size_t>(3 * y)]);
        block.image.channels[c].samples = numbers;
    }
    block.image.metadata.insert(block.image.metadata.begin() + 5, {{"grsh:startcolumn", std::to_string(left)},
                                                                   {"grsh:stopcolumn", std::to_string(right)}});
    return block;
}

TEST(Assemble, PutsBlocksInTheirPlaces) {
    const image::Image whole = assemble({block("d", 4, 9, 0, 0), block("a", 0, 3, 0, 1), block("c", 4, 9, 1, 2),
                                         block("b", 0, 1, 2, 2), block("e", 2, 3, 2, 2)});
    EXPECT_EQ(whole.held, (image::Window{0, 0, 3, 10}));
    for (std::size_t i = 0; i < 30; ++i) {
        EXPECT_EQ(std::get<0>(whole.channels[0].samples)[i], i / 3);
        EXPECT_EQ(std::get<0>(whole.channels[1].samples)[i], i % 3);
        EXPECT_EQ(std::get<0>(whole.channels[2].samples)[i], 100 + i / 3);
    }
    EXPECT_EQ(whole.metadata, block("", 0, 9, 0, 2).image.metadata);
}

TEST(Assemble, RefusesPixelsThatNoneHasOrTwoHave) {
    EXPECT_EQ(errorOfStrips({block("a", 0, 9, 0, 0), block("b", 0, 9, 2, 2)}),
              "STRIP GAP [a] no strip has column 1 of lines 0 to 9");
    EXPECT_EQ(errorOfStrips({block("a", 0, 9, 0, 0), block("b", 0, 4, 1, 2), block("c", 6, 9, 1, 2)}),
              "STRIP GAP [a] no strip has columns 1 to 2 of line 5");
    EXPECT_EQ(errorOfStrips({block("a", 0, 4, 0, 0), block("b", 0, 4, 1, 2), block("c", 6, 9, 0, 2)}),
              "STRIP GAP [a] no strip has line 5, between \"b\" and \"c\"");
    EXPECT_EQ(errorOfStrips({block("a", 0, 9, 0, 1), block("b", 2, 5, 1, 2)}),
              "STRIP OVERLAP [b] \"a\" and \"b\" both have lines 2 to 5, column 1");
    // As many pixels as the whole has, but not those.
    EXPECT_EQ(errorOfStrips({block("a", 0, 9, 0, 1), block("b", 0, 9, 0, 0)}),
              "STRIP OVERLAP [b] \"a\" and \"b\" both have lines 0 to 9, column 0");
    Strip outside = block("a", 0, 9, 0, 2);
    outside.image.metadata[6].second = "3";
    EXPECT_EQ(errorOfStrips({outside}),
              "STRIP NONE [a] \"a\" is no strip as it was written: it says that it is lines 0 to 9, columns 0 to 3 of "
              "3 x 10 pixels, and has lines 0 to 9 of width 3");
}

TEST(Assemble, RefusesStripsOfDifferentRenders) {
    const auto error = [](const auto& change) {
        Strip other = strip("b", 4, 9);
        change(other.image);
        return errorOfStrips({strip("a", 0, 3), other});
    };
    EXPECT_EQ(error([](image::Image&) {}), "no error");
    const std::string start = "STRIP RENDER [b] \"b\" is of another render than \"a\": ";
    EXPECT_EQ(error([](image::Image& image) { image.metadata.back().second = "6"; }),
              start + "seed is \"6\", not \"5\"");
    EXPECT_EQ(error([](image::Image& image) { image.metadata[0].second = "b.gr"; }),
              start + "Scene is \"b.gr\", not \"a.gr\"");
    EXPECT_EQ(error([](image::Image& image) { image.metadata.pop_back(); }), start + "only \"a\" has a text seed");
    EXPECT_EQ(error([](image::Image& image) { image.metadata.emplace_back("grsh:median", "3"); }),
              start + "only \"b\" has a text median");
    EXPECT_EQ(error([](image::Image& image) { image.channels.push_back(image.channels[0]); }),
              start + "what it has of each pixel is \"R G B R\", not \"R G B\"");
    EXPECT_EQ(error([](image::Image& image) {
                  for (image::ImageChannel& channel : image.channels) channel.samples = std::vector<std::uint16_t>(18);
              }),
              "STRIP RENDER [b] \"b\" has other numbers of bits than \"a\"");
}

TEST(Assemble, MakesTheNoiseOfTheWholeOfTheSums) {
    const auto noisy = [](Strip strip, const std::string& sums) {
        strip.image.metadata.emplace_back("grsh:noise", "0.7");
        if (!sums.empty()) strip.image.metadata.emplace_back("grsh:noisesums", sums);
        return strip;
    };
    const std::string first = "0:1000 0:2 0:500 0:3", second = "1:4 0:5 1:6,0:1 0:7", none = "0:0 0:0 0:0 0:0";
    NoiseSums both = NoiseSums::fromText(first).value();
    both += NoiseSums::fromText(second).value();
    Strip expected = strip("", 0, 9);
    expected.image.metadata.emplace_back("grsh:noise", noiseText(estimateNoise(both, 4, 30).error));
    EXPECT_EQ(assemble({noisy(strip("b", 5, 9), second), noisy(strip("a", 0, 4), first)}).metadata,
              expected.image.metadata);
    expected.image.metadata.back().second = "0";
    EXPECT_EQ(assemble({noisy(strip("a", 0, 4), none), noisy(strip("b", 5, 9), none)}).metadata,
              expected.image.metadata);
    expected.image.metadata.back().second = "0.7";
    EXPECT_EQ(assemble({noisy(strip("a", 0, 9), "")}).metadata, expected.image.metadata);

    const std::string error =
        "STRIP NONE [b] \"b\" does not say how noisy it is (text grsh:noisesums), as a strip of "
        "gr_render does";
    for (const char* broken : {"", "0:1", "nan nan nan nan"})
        EXPECT_EQ(errorOfStrips({noisy(strip("a", 0, 4), first), noisy(strip("b", 5, 9), broken)}), error) << broken;
    EXPECT_EQ(errorOfStrips({noisy(strip("a", 0, 4), first), strip("b", 5, 9)}), error);
    EXPECT_EQ(errorOfStrips({noisy(strip("a", 5, 9), first), strip("b", 0, 4)}), error);
}

TEST(Assemble, RefusesWhatIsNoStrip) {
    Strip none = strip("a", 0, 9);
    none.image.metadata.clear();
    EXPECT_EQ(errorOfStrips({none}),
              "STRIP NONE [a] \"a\" does not say which lines of which render it has (no text grsh:width), as a .png or "
              "an .exr of gr_render does");
    for (const char* lie : {"-1", "1e3", "", "12x", "99999999999"}) {
        Strip broken = strip("a", 0, 9);
        broken.image.metadata[3].second = lie;
        EXPECT_THAT(errorOfStrips({broken}), testing::StartsWith("STRIP NONE [a] ")) << lie;
    }
    Strip cropped = strip("a", 0, 9);
    cropped.image.held.height = 8;
    EXPECT_EQ(errorOfStrips({cropped}),
              "STRIP NONE [a] \"a\" is no strip as it was written: it says that it is lines 0 to 9 of 3 x 10 pixels, "
              "and has lines 0 to 7 of width 3");
    Strip moved = strip("a", 0, 9);
    moved.image.held.top = 1;
    EXPECT_THAT(errorOfStrips({moved}), testing::HasSubstr("and has lines 1 to 10 of width 3"));
}

// The scene of scenes/cornell4.gr with fewer samples; what follows are {file startline stopline} ...
constexpr const char* cornell4 = R"(
rename gr_render render
proc gr_render {node file width height eye view up fov args} {
    foreach {file start stop} $::argv {
        render $node $file 150 150 $eye $view $up $fov {*}[dict merge $args {samplesperpixel 5 progress off}] \
            startline $start stopline $stop {*}$::layers
    }
}
source [file join )" GRSH_SCENES R"( cornell4.gr]
)";

TEST(AssembleProgram, MakesTheBytesOfTheWholeOfStripsRenderedByThreeProcessesAtOnce) {
    for (const std::string ending : {"png", "exr"}) {
        const TemporaryFolder folder;
        const std::string layers = ending == "exr" ? "set layers {layers {normal depth samples}}\n" : "set layers {}\n";
        writeText(folder / "scene.gr", layers + cornell4);
        const auto name = [&](const std::string& strip) { return strip + "." + ending; };
        {
            GrshProcess one(folder.path(),
                            {"scene.gr", name("1"), "0", "10", name("4"), "58", "58", name("7"), "140", "149"});
            GrshProcess two(folder.path(), {"scene.gr", name("2"), "11", "40", name("5"), "59", "120"});
            GrshProcess three(folder.path(), {"scene.gr", name("3"), "41", "57", name("6"), "121", "139"});
            for (GrshProcess* process : {&one, &two, &three}) ASSERT_EQ(process->exitCode(), 0);
        }
        ASSERT_EQ(GrshProcess(folder.path(), {"scene.gr", name("whole"), "0", "149"}).exitCode(), 0);
        std::string command = "gr_assemble " + name("all");
        for (const char* strip : {"7", "3", "1", "2", "5", "6", "4"}) command += " " + name(strip);
        writeText(folder / "assemble.gr", command);
        ASSERT_EQ(GrshProcess(folder.path(), {"assemble.gr"}).exitCode(), 0);
        EXPECT_TRUE(bytesOf(folder / name("all")) == bytesOf(folder / name("whole"))) << ending;
        EXPECT_GT(bytesOf(folder / name("whole")).size(), 20'000u) << "a picture of something";
    }
}

}  // namespace
}  // namespace render
