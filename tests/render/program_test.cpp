// Pictures that separate runs of grsh make: the same to the byte, and they say what made them.
#include "image/exr_reader.h"
#include "image/image_file.h"
#include "image/pfm_reader.h"
#include "image/png_reader.h"
#include "image/temporary_folder.h"
#include "render/grsh_process.h"
#include "render/settings.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace render {
using namespace image;
namespace {

using testing::Contains;
using testing::Key;
using testing::MatchesRegex;
using testing::Not;
using testing::Pair;

// Everything that draws random numbers; what follows the file's name are render options.
constexpr const char* script = R"(
gr_material brown diffuse diffuse {0.8 0.6 0.4}
gr_box : room {-2 -2 -2} {4 4 12}
gr_surfaceproperty :room brown
gr_sphere : ball {0.5 -1 0} 0.9
gr_material steel shirley diffuse {0.1 0.1 0.2} specular {0.6 0.5 0.4} exp {10 300} sampling {0.2 0.3 0 0.5}
gr_surfaceproperty :ball steel
gr_material bottle dielectric specular {0.2 0.2 0.2} beers {0.6 0.1 0.5} sampling {0 0.3 0.7 0} perturbation 2
gr_surfaceproperty [gr_sphere : glass {-0.8 -1 1} 0.8] bottle
gr_als_planar : lamp {9 8 7} {0 1.9 0} 1.5
gr_light bulb {1 1 4} {0.5 0.5 1} {0 0 1}
gr_light spare {0 0 0} {1 1 1} {1 0 0}
gr_render : [lindex $argv 0] 30 20 {0 0 6} {0 0.25 -2} {0 1 0} 50 {0.1 0.2 0.3} {bulb} \
    globalillumination on pathlength 3 antialiasing on samplesperlightsource 2 {*}[lrange $argv 1 end] progress off
)";

class Program : public testing::Test {
protected:
    Program() { writeText(folder / "scene.gr", script); }

    std::unique_ptr<GrshProcess> start(std::vector<std::string> words) const {
        words.insert(words.begin(), "scene.gr");
        return std::make_unique<GrshProcess>(folder.path(), words);
    }
    void run(const std::vector<std::string>& words) const { ASSERT_EQ(start(words)->exitCode(), 0); }

    TemporaryFolder folder;
};

TEST_F(Program, MakesStripsThatAreTheWhole) {
    run({"whole.png"});
    auto top = start({"top.png", "stopline", "6"});
    auto line = start({"line.png", "startline", "7", "stopline", "7"});
    auto rest = start({"rest.png", "startline", "8"});
    for (const auto& process : {&top, &line, &rest}) ASSERT_EQ((*process)->exitCode(), 0);

    std::vector<std::vector<png_byte>> lines;
    for (const char* name : {"top.png", "line.png", "rest.png"}) {
        const Png strip(folder / name);
        EXPECT_EQ(strip.offset, std::pair(0, static_cast<int>(lines.size()))) << name;
        EXPECT_EQ(strip.texts.at("grsh:startline"), std::to_string(lines.size()));
        EXPECT_EQ(strip.texts.at("grsh:height"), "20");
        lines.insert(lines.end(), strip.lines.begin(), strip.lines.end());
    }
    const Png whole(folder / "whole.png");
    EXPECT_EQ(whole.lines, lines);
    EXPECT_EQ(whole.offset, std::nullopt);
    EXPECT_THAT(whole.lines, Contains(Not(whole.lines[0])).Times(testing::Gt(15))) << "a picture of something";
}

TEST_F(Program, MakesTheSameFileTwice) {
    run({"first.png"});
    run({"second.png"});
    run({"one-thread.png", "threads", "1"});
    run({"many-threads.png", "threads", "5"});
    const std::string bytes = bytesOf(folder / "first.png");
    EXPECT_FALSE(bytes.empty());
    for (const char* name : {"second.png", "one-thread.png", "many-threads.png"})
        EXPECT_TRUE(bytesOf(folder / name) == bytes) << name;
    run({"other-seed.png", "seed", "1"});
    EXPECT_NE(Png(folder / "other-seed.png").lines, Png(folder / "first.png").lines);
}

TEST_F(Program, MakesExrStripsThatAreTheWhole) {
    const std::vector<std::string> layers{"layers", "samples normal depth albedo variance"};
    const auto runStrip = [&](const std::string& name, std::vector<std::string> words) {
        words.insert(words.begin(), {name, layers[0], layers[1]});
        run(words);
        return Exr(folder / name);
    };
    const Exr whole = runStrip("whole.exr", {});
    const Exr top = runStrip("top.exr", {"stopline", "6"});
    const Exr rest = runStrip("rest.exr", {"startline", "7"});
    const Imath::Box2i picture({0, 0}, {29, 19});
    EXPECT_EQ(whole.dataWindow, picture);
    EXPECT_EQ(top.dataWindow, Imath::Box2i({0, 0}, {29, 6}));
    EXPECT_EQ(rest.dataWindow, Imath::Box2i({0, 7}, {29, 19}));
    EXPECT_EQ(whole.channels.size(), 14u);
    for (const Exr* exr : {&whole, &top, &rest}) EXPECT_EQ(exr->displayWindow, picture);
    for (const auto& [name, numbers] : whole.channels) {
        std::vector<float> strips = top.channels.at(name);
        strips.insert(strips.end(), rest.channels.at(name).begin(), rest.channels.at(name).end());
        EXPECT_EQ(strips, numbers) << name;
    }
}

TEST_F(Program, MakesTheSameLinearFileTwice) {
    for (const std::string ending : {".exr", ".pfm"}) {
        std::vector<std::string> layers;
        if (ending == ".exr") layers = {"layers", "albedo normal depth variance samples"};
        for (const char* threads : {"1", "5", "0"}) {
            std::vector<std::string> words{threads + ending, "threads", threads};
            words.insert(words.end(), layers.begin(), layers.end());
            run(words);
        }
        const std::string bytes = bytesOf(folder / ("1" + ending));
        EXPECT_FALSE(bytes.empty());
        for (const char* name : {"5", "0"}) EXPECT_TRUE(bytesOf(folder / (name + ending)) == bytes) << name << ending;
    }
}

TEST_F(Program, HasTheSamePictureInEveryFormat) {
    const std::vector<std::string> options{"samplesperpixel", "3", "startline", "2"};
    for (const std::string name : {"a.png", "a.exr", "a.pfm"})
        run({name, options[0], options[1], options[2], options[3]});
    run({"layers.exr", options[0], options[1], options[2], options[3], "layers", "variance depth"});
    const Png png(folder / "a.png");
    const Exr exr(folder / "a.exr"), layers(folder / "layers.exr");
    const Pfm pfm(folder / "a.pfm");
    const char* channels[] = {"R", "G", "B"};
    for (int y = 0; y < 18; ++y) {
        for (int x = 0; x < 30; ++x) {
            for (int c = 0; c < 3; ++c) {
                const float radiance = exr.at(channels[c], x, y + 2);
                ASSERT_EQ(png.lines[static_cast<std::size_t>(y)][static_cast<std::size_t>(3 * x + c)],
                          image::toByte(image::Curve::srgb, radiance));
                ASSERT_EQ(pfm.at(x, y)[c], radiance);
                ASSERT_EQ(layers.at(channels[c], x, y + 2), radiance);
            }
        }
    }
    EXPECT_EQ(png.lines.size(), 18u);
}

TEST_F(Program, SaysInAnExrWhatItSaysInAPng) {
    const std::vector<std::string> options{"seed", "12", "exposure", "-0.5", "samplesperpixel", "2", "stopline", "3"};
    for (const std::string name : {"a.png", "a.exr"}) {
        std::vector<std::string> words = options;
        words.insert(words.begin(), name);
        run(words);
    }
    std::map<std::string, std::string> texts = Png(folder / "a.png").texts;
    EXPECT_THAT(texts, Contains(Pair("grsh:seed", "12")));
    texts["type"] = "scanlineimage";
    const Exr exr(folder / "a.exr");
    EXPECT_EQ(exr.texts, texts);
    // Beside them only what the format asks for: no date.
    std::vector<std::string> names{"channels",         "chromaticities",     "compression",
                                   "dataWindow",       "displayWindow",      "lineOrder",
                                   "pixelAspectRatio", "screenWindowCenter", "screenWindowWidth"};
    for (const auto& [name, text] : texts) names.push_back(name);
    EXPECT_THAT(exr.attributes, testing::UnorderedElementsAreArray(names));
}

TEST_F(Program, LooksThroughALensOnlyWhereItIsAskedTo) {
    run({"pinhole.png"});
    run({"off.png", "aperture", "0.5", "focaldistance", "3"});
    run({"closed.png", "depthoffield", "on", "aperture", "0", "focaldistance", "3"});
    run({"lens.png", "depthoffield", "on", "aperture", "0.5", "focaldistance", "3"});
    const auto pinhole = Png(folder / "pinhole.png").lines;
    EXPECT_EQ(Png(folder / "off.png").lines, pinhole);
    EXPECT_EQ(Png(folder / "closed.png").lines, pinhole);
    EXPECT_NE(Png(folder / "lens.png").lines, pinhole);
}

TEST_F(Program, SaysInThePictureWhatMadeIt) {
    run({"a.png", "seed", "9223372036854775807", "samplesperpixel", "3", "exposure", "-0.5", "background",
         "0 0.25 1e-6", "threads", "2", "stopline", "12"});
    std::map<std::string, std::string> texts = Png(folder / "a.png").texts;
    EXPECT_THAT(texts["Software"], MatchesRegex("grsh [0-9]+[.][0-9]+[.][0-9]+"));
    texts.erase("Software");
    EXPECT_THAT(texts["grsh:fingerprint"], MatchesRegex("[0-9]+"));
    texts.erase("grsh:fingerprint");
    EXPECT_THAT(
        texts,
        testing::UnorderedElementsAre(
            Pair("Scene", "scene.gr"), Pair("grsh:node", ":"), Pair("grsh:width", "30"), Pair("grsh:height", "20"),
            Pair("grsh:eye", "0 0 6"), Pair("grsh:view", "0 0.25 -2"), Pair("grsh:up", "0 1 0"), Pair("grsh:fov", "50"),
            Pair("grsh:ambient", "0.1 0.2 0.3"), Pair("grsh:lights", "bulb"), Pair("grsh:accelerator", "auto"),
            Pair("grsh:globalillumination", "on"), Pair("grsh:antialiasing", "on"), Pair("grsh:pathlength", "3"),
            Pair("grsh:depthoffield", "off"), Pair("grsh:focaldistance", "1"), Pair("grsh:aperture", "0.1"),
            Pair("grsh:projection", "perspective"), Pair("grsh:curve", "srgb"), Pair("grsh:startcolumn", "0"),
            Pair("grsh:stopcolumn", "29"), Pair("grsh:startline", "0"), Pair("grsh:stopline", "12"),
            Pair("grsh:samplesperpixel", "3"), Pair("grsh:samplesperlightsource", "2"), Pair("grsh:integrator", "path"),
            Pair("grsh:seed", "9223372036854775807"), Pair("grsh:background", "0 0.25 1e-06"),
            Pair("grsh:environment", ""), Pair("grsh:environmentrotation", "0"), Pair("grsh:exposure", "-0.5"),
            Pair("grsh:stopped", "samplesperpixel")));
}

// Whatever options there are one day: each that changes the picture is in it, and no other.
TEST_F(Program, SaysEveryOptionThatChangesThePicture) {
    run({"a.png"});
    const std::map<std::string, std::string> texts = Png(folder / "a.png").texts;
    for (const auto& row : RenderSettings::options()) {
        // There the picture's own noise stands, not what was asked for.
        if (row.name == "noise") continue;
        const std::string key = "grsh:" + std::string(row.name);
        if (row.inPicture)
            EXPECT_THAT(texts, Contains(Key(key)));
        else
            EXPECT_THAT(texts, Not(Contains(Key(key))));
    }
    EXPECT_THAT(texts, Not(Contains(Key("grsh:threads"))));
}

// The kinds of chunks in the file. tIME and eXIf, which hold dates, are none of them.
TEST_F(Program, SaysNothingOfTheTime) {
    run({"a.png"});
    const std::vector<std::string> kinds = chunkKinds(folder / "a.png");
    EXPECT_THAT(kinds, testing::Each(testing::AnyOf("IHDR", "sRGB", "gAMA", "cHRM", "tEXt", "IDAT", "IEND")));
    EXPECT_EQ(kinds.back(), "IEND");
}

TEST_F(Program, LeavesNothingBesideThePicture) {
    run({"a.png"});
    EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("scene.gr", "a.png"));
}

// Two lines from the middle of each scene that comes with grsh, with few samples.
TEST_F(Program, RendersEveryScene) {
    writeText(folder / "two-lines.gr", R"(
rename gr_render render
proc gr_render {node file width height args} {
    set samples [lsearch $args samplesperpixel]
    if {$samples >= 0} {set args [lreplace $args $samples $samples+1]}
    lappend args samplesperpixel 4
    render $node $file $width $height {*}$args startline [expr {$height / 2}] stopline [expr {$height / 2 + 1}] progress off
}
source [lindex $argv 0]
)");
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(GRSH_SCENES)) {
        if (entry.path().extension() != ".gr") continue;
        ++scenes;
        SCOPED_TRACE(entry.path());
        ASSERT_EQ(GrshProcess(folder.path(), {"two-lines.gr", entry.path()}).exitCode(), 0);
        const Png png(folder / (entry.path().stem().string() + ".png"));
        EXPECT_EQ(png.height, 2);
        const auto [darkest, brightest] = std::minmax_element(png.lines[0].begin(), png.lines[0].end());
        EXPECT_GT(*brightest - *darkest, 20);
    }
    EXPECT_GT(scenes, 0);
}

}  // namespace
}  // namespace render
