// OpenEXR files and portable float maps: the film's own numbers, to the bit.
#include "image/exr_reader.h"
#include "image/image_file.h"
#include "image/image_samples.h"
#include "image/pfm_reader.h"
#include "support/test_random.h"

#include "core/error.h"

#include <gmock/gmock.h>

#include <bit>

namespace image {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

std::uint32_t bitsOf(float x) {
    return std::bit_cast<std::uint32_t>(x);
}

// Whatever bits a float may have, but NaN: extremes first, then noise.
class AnyFloat {
public:
    float next() {
        constexpr float inf = core::infinity;
        const float first[] = {0.f, -0.f, 1e-45f, -1e-38f, 3.4e38f, inf, -inf, 1.f / 3, 65504.f, 65536.f, 16777217.f};
        if (count_ < std::size(first)) return first[count_++];
        for (;;) {
            const float x = std::bit_cast<float>(static_cast<std::uint32_t>(random_.nextBits()));
            if (!std::isnan(x)) return x;
        }
    }

private:
    std::size_t count_ = 0;
    support::TestRandom random_{3};
};

Film anyFilm(int width, int height, int startLine, int lines, std::span<const Layer> layers = {}) {
    Film film(width, height, startLine, lines, layers);
    AnyFloat number;
    for (int y = startLine; y < startLine + lines; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) film.at(x, y)[c] = number.next();
            for (const Layer layer : layers)
                for (float& value : film.at(layer, x, y)) value = number.next();
        }
    }
    return film;
}

template<class File>
File written(const Film& film, const std::string& name, const Metadata& metadata = {}, double exposure = 0) {
    const TemporaryFolder folder;
    ImageFile(folder / name).write(film, exposure, metadata);
    EXPECT_THAT(folder.names(), ElementsAre(name));
    return File(folder / name);
}

void expectRadiance(const Exr& exr, const Film& film) {
    const char* names[] = {"R", "G", "B"};
    for (int y = film.startLine(); y < film.startLine() + film.lines(); ++y)
        for (int x = 0; x < film.width(); ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(bitsOf(exr.at(names[c], x, y)), bitsOf(film.at(x, y)[c])) << x << " " << y << " " << c;
}

// 16 lines make a chunk: of several, of a part of one, and of one.
TEST(ExrFile, HoldsTheRadianceToTheBit) {
    for (const auto& [width, height] : {std::pair(7, 37), {33, 32}, {1, 16}, {1, 1}, {300, 2}}) {
        const Film film = anyFilm(width, height, 0, height);
        const Exr exr = written<Exr>(film, "a.exr");
        EXPECT_TRUE(exr.isComplete);
        EXPECT_EQ(exr.dataWindow, Imath::Box2i({0, 0}, {width - 1, height - 1}));
        EXPECT_EQ(exr.displayWindow, exr.dataWindow);
        EXPECT_EQ(exr.compression, Imf::ZIP_COMPRESSION);
        EXPECT_THAT(exr.types, ElementsAre(Pair("B", Imf::FLOAT), Pair("G", Imf::FLOAT), Pair("R", Imf::FLOAT)));
        expectRadiance(exr, film);
    }
}

TEST(ExrFile, HoldsEveryLayerToTheBit) {
    const Film film = anyFilm(9, 40, 3, 21, everyLayer);
    const Exr exr = written<Exr>(film, "a.exr");
    expectRadiance(exr, film);
    std::vector<std::string> names{"R", "G", "B"};
    for (const Layer layer : everyLayer) {
        for (std::size_t c = 0; c < channelsOf(layer).size(); ++c) {
            names.emplace_back(channelsOf(layer)[c]);
            EXPECT_EQ(exr.types.at(names.back()), Imf::FLOAT);
            for (int y = 3; y < 24; ++y)
                for (int x = 0; x < 9; ++x)
                    ASSERT_EQ(bitsOf(exr.at(names.back(), x, y)), bitsOf(film.at(layer, x, y)[c])) << names.back();
        }
    }
    std::vector<std::string> found;
    for (const auto& [name, numbers] : exr.channels) found.push_back(name);
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(names));
}

TEST(ExrFile, HoldsTheLayersThatTheFilmHasWhateverTheirOrder) {
    const TemporaryFolder folder;
    const std::array<Layer, 2> one{Layer::depth, Layer::samples}, other{Layer::samples, Layer::depth};
    ImageFile(folder / "a.exr", one).write(Film(2, 2, 0, 2, one), 0, {});
    ImageFile(folder / "b.exr", other).write(Film(2, 2, 0, 2, other), 0, {});
    EXPECT_EQ(bytesOf(folder / "a.exr"), bytesOf(folder / "b.exr"));
    EXPECT_EQ(Exr(folder / "a.exr").channels.size(), 5u);
    EXPECT_EQ(Exr(folder / "a.exr").channels.count("Z"), 1u);
}

TEST(ExrFile, HasAStripAsDataWindowInTheDisplayWindow) {
    for (const auto& [start, lines] : {std::pair(30, 7), {0, 7}, {63, 37}, {99, 1}}) {
        const Film film = anyFilm(4, 100, start, lines);
        const Exr exr = written<Exr>(film, "a.exr");
        EXPECT_EQ(exr.displayWindow, Imath::Box2i({0, 0}, {3, 99}));
        EXPECT_EQ(exr.dataWindow, Imath::Box2i({0, start}, {3, start + lines - 1}));
        EXPECT_TRUE(exr.isComplete);
        expectRadiance(exr, film);
    }
}

TEST(ExrFile, HoldsItsTextsToTheLetter) {
    const Metadata metadata{{"Software", "grsh 1.2"},
                            {"Scene", "b\xc3\xbchne \xe2\x98\x80.gr"},
                            {"grsh:lights", ""},
                            {"grsh:samplesperlightsource", "1 -2.5 1e-07"},
                            {"Comment", "one line\nand another"},
                            {"Long", std::string(70'000, 'x')}};
    std::map<std::string, std::string> texts(metadata.begin(), metadata.end());
    texts["type"] = "scanlineimage";  // the format's own
    EXPECT_EQ(written<Exr>(Film(1, 1, 0, 1), "a.exr", metadata).texts, texts);
}

TEST(ExrFile, DeclaresItsColourSpace) {
    const Exr exr = written<Exr>(Film(1, 1, 0, 1), "a.exr");
    const auto hasPlace = [](const Imath::V2f& place, float x, float y) { return place == Imath::V2f(x, y); };
    EXPECT_TRUE(hasPlace(exr.chromaticities.red, 0.64f, 0.33f));
    EXPECT_TRUE(hasPlace(exr.chromaticities.green, 0.3f, 0.6f));
    EXPECT_TRUE(hasPlace(exr.chromaticities.blue, 0.15f, 0.06f));
    EXPECT_TRUE(hasPlace(exr.chromaticities.white, 0.3127f, 0.329f));
}

TEST(ExrFile, CallsItsChannelsAsTheFieldDoes) {
    EXPECT_THAT(channelsOf(Layer::albedo), ElementsAre("albedo.R", "albedo.G", "albedo.B"));
    EXPECT_THAT(channelsOf(Layer::normal), ElementsAre("normal.X", "normal.Y", "normal.Z"));
    EXPECT_THAT(channelsOf(Layer::depth), ElementsAre("Z"));
    EXPECT_THAT(channelsOf(Layer::variance), ElementsAre("variance.R", "variance.G", "variance.B"));
    EXPECT_THAT(channelsOf(Layer::samples), ElementsAre("samples"));
    EXPECT_EQ(layersNamed(layerNames()), std::vector<Layer>(everyLayer.begin(), everyLayer.end()));
    EXPECT_THAT(layerNames(), ElementsAre("albedo", "normal", "depth", "variance", "samples"));
}

// The whole file, with the white space that the format asks for.
TEST(PfmFile, IsLittleEndianFromTheBottomLineUp) {
    const TemporaryFolder folder;
    Film film(2, 2, 0, 2);
    film.at(0, 0) = core::Rgbf(1, 2, 3);
    film.at(1, 1) = core::Rgbf(-0.5f, 0, 0);
    ImageFile(folder / "a.pfm").write(film, 0, {{"Software", "grsh"}});
    using namespace std::string_literals;
    EXPECT_EQ(bytesOf(folder / "a.pfm"), "PF\n2 2\n-1.0\n"s + std::string(12, '\0') + "\0\0\0\xbf\0\0\0\0\0\0\0\0"s +
                                             "\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40"s + std::string(12, '\0'));
}

TEST(PfmFile, HoldsTheRadianceToTheBit) {
    for (const auto& [start, lines] : {std::pair(0, 50), {13, 20}, {49, 1}}) {
        const Film film = anyFilm(11, 50, start, lines);
        const Pfm pfm = written<Pfm>(film, "a.pfm");
        EXPECT_EQ(pfm.width, 11);
        ASSERT_EQ(pfm.height, lines) << "only the strip";
        EXPECT_EQ(pfm.scale, -1);
        for (int y = 0; y < lines; ++y)
            for (int x = 0; x < 11; ++x)
                for (int c = 0; c < 3; ++c)
                    ASSERT_EQ(bitsOf(pfm.at(x, y)[c]), bitsOf(film.at(x, start + y)[c])) << x << " " << y;
    }
}

class LinearFile : public testing::TestWithParam<const char*> {
protected:
    std::string name(const std::string& base) const { return base + GetParam(); }
    TemporaryFolder folder;
};
INSTANTIATE_TEST_SUITE_P(Every, LinearFile, testing::Values(".exr", ".pfm"),
                         [](const auto& info) { return std::string(info.param + 1); });

TEST_P(LinearFile, IsNotExposed) {
    const Film film = anyFilm(3, 2, 0, 2);
    for (const auto& [base, exposure] : {std::pair("a", 0.0), {"b", 3.5}})
        ImageFile(folder / name(base)).write(film, exposure, {});
    EXPECT_EQ(bytesOf(folder / name("a")), bytesOf(folder / name("b")));
    EXPECT_FALSE(bytesOf(folder / name("a")).empty());
}

TEST_P(LinearFile, TakesItsEndingInAnyCase) {
    std::string upper = name("a.tar");
    std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
    const Film film = anyFilm(3, 2, 0, 2);
    ImageFile(folder / upper).write(film, 0, {});
    ImageFile(folder / name("b")).write(film, 0, {});
    EXPECT_EQ(bytesOf(folder / upper), bytesOf(folder / name("b")));
}

// Where the header, the pixels and what is written last do not fit.
TEST_P(LinearFile, IsAbsentWhenTheDiskIsFull) {
    const Film film = anyFilm(100, 90, 0, 90);
    ImageFile(folder / name("whole")).write(film, 0, {});
    const std::size_t size = bytesOf(folder / name("whole")).size();
    writeText(folder / name("old"), "as it was");
    for (const std::size_t room : {std::size_t{0}, std::size_t{4}, std::size_t{300}, size / 2, size - 1}) {
        for (const char* base : {"new", "old"}) {
            const ImageFile file(folder / name(base));
            std::string message;
            {
                const FullDisk disk(room);
                try {
                    file.write(film, 0, {});
                } catch (const core::Error& error) {
                    message = error.what();
                    EXPECT_EQ(error.topic, "FILE");
                    EXPECT_EQ(error.word, folder / name(base));
                }
            }
            EXPECT_EQ(message, "cannot write \"" + (folder / name(base)) + "\": File too large") << room;
        }
        EXPECT_THAT(folder.names(), testing::UnorderedElementsAre(name("whole"), name("old"))) << room;
        EXPECT_EQ(bytesOf(folder / name("old")), "as it was") << room;
    }
}

TEST(LayersRefusal, OfAFileThatHoldsNone) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.PNG", "a.pfm"}) {
        try {
            const ImageFile file(folder / name, everyLayer);
            ADD_FAILURE() << name;
        } catch (const core::Error& error) {
            EXPECT_EQ(error.what(),
                      "cannot write \"" + (folder / name) + "\": with layers the file's ending must be .exr");
            EXPECT_EQ(error.reason, "LAYERS");
        }
        EXPECT_NO_THROW(ImageFile(folder / name, {})) << name;
    }
    EXPECT_NO_THROW(ImageFile(folder / "a.exr", everyLayer));
    EXPECT_THAT(folder.names(), testing::IsEmpty());
}

}  // namespace
}  // namespace image
