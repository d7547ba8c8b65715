// A render that is broken off and gone on with, in this process or from a file, makes the picture of one that was not.
// Seen to fail where the way from the last power of two is forgotten, and where a file leaves out the mean at the last
// power of two.
#include "render/accumulate/state_file.h"
#include "render/render.h"
#include "support/error_of.h"
#include "support/test_random.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace render {
namespace {

namespace fs = std::filesystem;
using support::errorOf;

constexpr int width = 40, height = 35;

// Noise, some of it bright and some of it not finite. It stops whoever asks for it at the sample that was set.
class Noise : public ScalarIntegrator {
public:
    core::Rgbf radiance(const core::Rayf&, Sampler& sampler, RayCounts& rays, FirstSurface* first) const override {
        if (--left == 0) stop = true;
        ++rays.shadow;
        const core::Vec2f u = sampler.next2D(), v = sampler.next2D();
        if (first != nullptr) *first = {3 + u.x, core::Rgbf(u.y), core::Vec3f(v.x, v.y, 0)};
        const float x = v.y < 0.001f ? core::infinity : v.y < 0.01f ? 1000 : 1;
        return {u.x * x, u.y, v.x * 1e-3f};
    }

    mutable std::atomic<long> left = 0;
    mutable std::atomic<bool> stop = false;
};

class AccumulationTest : public testing::Test {
protected:
    AccumulationTest() : folder_(fs::temp_directory_path() / ("grsh-state-test-" + std::to_string(getpid()))) {
        fs::create_directory(folder_);
    }
    ~AccumulationTest() override { fs::remove_all(folder_); }

    static RenderSettings settingsFor(int kind) {
        RenderSettings settings;
        settings.antialiasing = true;
        settings.threads = 1 + kind;
        if (kind == 0) settings.samplesPerPixel = 21;
        if (kind == 1) settings.noise = 0.35;
        if (kind == 2) {
            settings.noise = 1e-6;
            settings.samplesPerPixel = 37;
        }
        return settings;
    }
    static image::Film emptyFilm(bool hasLayers, int startLine = 3) {
        constexpr std::array all{image::Layer::albedo, image::Layer::normal, image::Layer::depth,
                                 image::Layer::variance, image::Layer::samples};
        return image::Film(width, height, startLine, height - startLine,
                           hasLayers ? std::span<const image::Layer>(all) : std::span<const image::Layer>());
    }
    RenderResult goOn(Accumulation& accumulation, const RenderSettings& settings) const {
        Progress progress;
        return render(accumulation, integrator_, camera_, settings, progress, integrator_.stop);
    }
    std::string path() const { return (folder_ / "x.png.grsh-state").string(); }

    const Noise integrator_;
    const Camera camera_{{0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 40, width, height};
    const StateWords words_{{"scene", "12"}, {"fov", "40"}};
    fs::path folder_;
};

void expectSame(const Accumulation& found, const RenderResult& result, const Accumulation& expected,
                const RenderResult& asIf, bool hasLayers) {
    EXPECT_EQ(result.samplesPerPixel, asIf.samplesPerPixel);
    EXPECT_EQ(result.noise, asIf.noise);
    EXPECT_EQ(result.noiseSums->text(), asIf.noiseSums->text());
    EXPECT_EQ(result.stoppedBy, asIf.stoppedBy);
    EXPECT_EQ(result.samples, asIf.samples);
    EXPECT_EQ(result.rays.total(), asIf.rays.total());
    EXPECT_EQ(result.droppedSamples, asIf.droppedSamples);
    ASSERT_EQ(found.tiles.size(), expected.tiles.size());
    int different = 0;
    for (std::size_t i = 0; i < found.tiles.size(); ++i) {
        different += found.tiles[i].pixels != expected.tiles[i].pixels;
        EXPECT_EQ(found.tiles[i].layers.size(), hasLayers ? found.tiles[i].pixels.size() : 0);
        for (std::size_t p = 0; p < found.tiles[i].layers.size(); ++p) {
            std::vector<double> a, b;
            PixelLayers(found.tiles[i].layers[p]).forEachNumber([&](double& x) { a.push_back(x); });
            PixelLayers(expected.tiles[i].layers[p]).forEachNumber([&](double& x) { b.push_back(x); });
            different += a != b;
        }
    }
    EXPECT_EQ(different, 0);
}

TEST_F(AccumulationTest, IsTheSameHoweverOftenItIsBrokenOff) {
    support::TestRandom random(1);
    for (const bool hasLayers : {false, true})
        for (int kind = 0; kind < 3; ++kind) {
            const RenderSettings settings = settingsFor(kind);
            const image::Film film = emptyFilm(hasLayers);
            Accumulation whole(film);
            const RenderResult once = goOn(whole, settings);
            ASSERT_NE(once.stoppedBy, StoppedBy::interrupt);
            for (const bool isInFile : {false, true}) {
                std::optional<Accumulation> broken(film);
                RenderResult result;
                int breaks = -1;
                do {
                    integrator_.stop = false;
                    integrator_.left = 1 + static_cast<long>(random.next() * 9000);
                    if (isInFile && breaks >= 0) {
                        writeState(path(), words_, *broken, 2);
                        broken.emplace(film);
                        ASSERT_TRUE(readState(path(), words_, settings.mostSamples(), *broken));
                    }
                    result = goOn(*broken, settings);
                    ++breaks;
                } while (result.stoppedBy == StoppedBy::interrupt);
                integrator_.left = 0;
                EXPECT_GT(breaks, 3);
                expectSame(*broken, result, whole, once, hasLayers);
            }
        }
}

// Of a finished picture come more samples, the same as if they had been asked for at once.
TEST_F(AccumulationTest, GrowsLater) {
    RenderSettings few = settingsFor(0), many = few;
    many.samplesPerPixel = 70;
    const image::Film film = emptyFilm(false);
    Accumulation whole(film), grown(film);
    const RenderResult once = goOn(whole, many);
    goOn(grown, few);
    writeState(path(), words_, grown, 2);
    Accumulation again(film);
    ASSERT_TRUE(readState(path(), words_, 70, again));
    expectSame(again, goOn(again, many), whole, once, false);
    EXPECT_EQ(errorOf([&] { readState(path(), words_, 20, again); }),
              "STATE SAMPLES [" + path() + "] cannot resume from \"" + path() +
                  "\": it has 21 samples per pixel already, more than the 20 asked for");
}

// A pass of a fixed number is long, those of noise are short: the broken one is ended first, or its noise would be that
// of some tiles only.
TEST_F(AccumulationTest, GoesOnWithAnotherAim) {
    RenderSettings fixed = settingsFor(0), noisy = settingsFor(1);
    fixed.samplesPerPixel = 64;
    const image::Film film = emptyFilm(false);
    Accumulation whole(film), broken(film);
    integrator_.left = 49 * width * (height - 3);
    EXPECT_EQ(goOn(broken, fixed).stoppedBy, StoppedBy::interrupt);
    integrator_.stop = false;
    const RenderResult once = goOn(whole, fixed);
    noisy.noise = 1.01 * once.noise.value();
    const RenderResult result = goOn(broken, noisy);
    EXPECT_EQ(result.samplesPerPixel, 64);
    EXPECT_EQ(result.noise, once.noise);
    EXPECT_EQ(result.samples, once.samples);
}

TEST_F(AccumulationTest, IsWrittenWhileItIsRendered) {
    RenderSettings settings = settingsFor(0);
    settings.samplesPerPixel = 300;
    Accumulation accumulation(emptyFilm(false));
    int written = 0, most = 0;
    const Checkpoints checkpoints{0.002, [&] {
                                      ++written;
                                      EXPECT_GE(accumulation.samplesPerPixel(), most);
                                      most = accumulation.samplesPerPixel();
                                      writeState(path(), words_, accumulation, 2);
                                  }};
    Progress progress;
    const RenderResult result =
        render(accumulation, integrator_, camera_, settings, progress, integrator_.stop, checkpoints);
    EXPECT_EQ(result.stoppedBy, StoppedBy::samplesPerPixel);
    EXPECT_GE(written, 1);
    Accumulation read(emptyFilm(false));
    EXPECT_TRUE(readState(path(), words_, 300, read));
    EXPECT_EQ(read.samplesPerPixel(), most);
}

TEST_F(AccumulationTest, RefusesWhatIsOfAnotherPicture) {
    Accumulation accumulation(emptyFilm(false));
    EXPECT_FALSE(readState(path(), words_, 99, accumulation)) << "there is none";
    goOn(accumulation, settingsFor(0));
    writeState(path(), words_, accumulation, 1);
    const auto error = [&](const StateWords& words) {
        return errorOf([&] { readState(path(), words, 99, accumulation); });
    };
    const std::string start = "STATE OTHER [" + path() + "] cannot resume from \"" + path() + "\": ";
    EXPECT_EQ(error({{"scene", "12"}, {"fov", "45"}}), start + "it was rendered with another fov, \"40\", not \"45\"");
    EXPECT_EQ(error({{"scene", "13"}, {"fov", "45"}}),
              start + "it was rendered with another scene, \"12\", not \"13\"");
    EXPECT_EQ(error({{"scene", "12"}}), start + "it was rendered by another grsh");
    EXPECT_EQ(error({{"scene", "12"}, {"lights", ""}}), start + "it was rendered with another lights");
}

// Whatever has become of it, it is refused and stays as it is.
TEST_F(AccumulationTest, RefusesWhatIsDamaged) {
    Accumulation accumulation(emptyFilm(true));
    goOn(accumulation, settingsFor(0));
    writeState(path(), words_, accumulation, 1);
    std::string whole;
    {
        std::ifstream file(path(), std::ios::binary);
        whole.assign(std::istreambuf_iterator<char>(file), {});
    }
    support::TestRandom random(2);
    const auto expectRefused = [&](const std::string& bytes) {
        std::ofstream(path(), std::ios::binary) << bytes;
        EXPECT_EQ(errorOf([&] { readState(path(), words_, 99, accumulation); }),
                  "STATE DAMAGED [" + path() + "] cannot resume from \"" + path() + "\": it is damaged");
        EXPECT_EQ(fs::file_size(path()), bytes.size());
    };
    expectRefused("");
    for (int i = 0; i < 200; ++i) {
        std::string bytes = whole;
        const auto at = static_cast<std::size_t>(random.next() * static_cast<double>(whole.size()));
        if (i % 2 == 0)
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << i % 8));
        else
            bytes.resize(at);
        expectRefused(bytes);
    }
}

TEST_F(AccumulationTest, TakesAtMost32BytesAPixel) {
    RenderSettings settings;
    settings.antialiasing = true;
    for (const int samples : {1, 5, 64, 100}) {
        settings.samplesPerPixel = samples;
        const image::Film film(400, 300, 0, 300);
        Accumulation accumulation(film);
        goOn(accumulation, settings);
        writeState(path(), words_, accumulation, 2);
        EXPECT_LE(static_cast<double>(fs::file_size(path())) / (400 * 300), 32) << samples;
    }
}

}  // namespace
}  // namespace render
