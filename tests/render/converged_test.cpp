// The path integrator against the converged pictures of other renderers: see tests/reference/README.md.
// The noise is no greater than it was, either: what is right in the mean can still be slower to get there.
// Seen to fail with a bounce's density 2 % too large, with Russian roulette that is not made up for, with light that
// both ways to find it bring in full, and with rays that start 4 units off a surface. The noise was seen to be too much
// with paths that go on from diffuse surfaces in all directions alike, and not by the cosine: 2.0 times what it is in
// a, 1.7 times in bas, 1.3 in c, 2.0 in d and 1.8 in e. Direct light, a-direct, has no such paths.
#include "image/exr_reader.h"
#include "image/temporary_folder.h"
#include "render/grsh_process.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace render {
using namespace image;
namespace {

constexpr int size = 256, blockSize = 16;

// Pixels from (left, top) to (right - 1, bottom - 1).
struct Area {
    int left, top, right, bottom;
};
constexpr Area whole{0, 0, size, size};

struct Converged {
    const char* name;  // of the picture in tests/reference/
    const char* scene;
    const char* options;
    double tolerance;  // of the whole picture's mean
    int samples;  // of each of the pictures that are compared with it
    double noise;  // their relMSE, which the README there explains, as it was measured
};

// What chance may do to `noise`: other random numbers change it by a few per cent.
constexpr double allowance = 1.15;

// With 7 degrees of freedom a block's mean lies beyond so many standard errors once in 11,000 times, and a picture has
// 256 blocks.
constexpr double farForBlock = 8;

void PrintTo(const Converged& picture, std::ostream* out) {
    *out << picture.name;
}

constexpr Converged pictures[] = {{"a", "reference-a.gr", "", 0.002, 32, 2.85e-3},
                                  {"a-direct", "reference-a.gr", "pathlength 1", 0.002, 32, 2.18e-5},
                                  {"bas", "reference-bas.gr", "", 0.005, 32, 2.97e-2},
                                  {"c", "reference-c.gr", "", 0.002, 32, 2.05e-3},
                                  {"d", "reference-d.gr", "", 0.002, 8, 6.65e-3},
                                  {"e", "reference-e.gr", "", 0.002, 8, 3.45e-2}};

// Pictures, each of another seed, rendered by grsh itself.
class Renders {
public:
    static constexpr int count = 8;

    explicit Renders(const Converged& picture) {
        const support::TemporaryFolder folder;
        std::ostringstream script;
        script << "rename gr_render render\n"
                  "proc gr_render {node file width height eye view up fov args} {\n"
                  "    for {set seed 1} {$seed <= "
               << count
               << "} {incr seed} {\n"
                  "        render $node $seed.exr $width $height $eye $view $up $fov {*}[dict merge $args {"
               << picture.options << " samplesperpixel " << picture.samples << " progress off}] seed $seed\n    }\n}\n"
               << "source {" GRSH_SCENES "/" << picture.scene << "}\n";
        writeText(folder / "converged.gr", script.str());
        EXPECT_EQ(GrshProcess(folder.path(), {"converged.gr"}).exitCode(), 0);
        for (int seed = 1; seed <= count; ++seed)
            pictures_.push_back(std::make_unique<Exr>(folder / (std::to_string(seed) + ".exr")));
    }

    // The mean of some channels, named by a letter each, over those pixels of an area that count: of each picture.
    support::RunningMean mean(const Exr& reference, const std::string& channels, const Area& area) const {
        support::RunningMean mean;
        for (const auto& picture : pictures_) mean.add(meanOf(*picture, reference, channels, area));
        return mean;
    }
    // Not a number where no pixel counts.
    static double meanOf(const Exr& picture, const Exr& reference, const std::string& channels, const Area& area) {
        double sum = 0, counting = 0;
        for (int y = area.top; y < area.bottom; ++y)
            for (int x = area.left; x < area.right; ++x) {
                if (reference.at("A", x, y) < 0.5f) continue;
                for (const char channel : channels) sum += picture.at(std::string(1, channel), x, y);
                counting += static_cast<double>(channels.size());
            }
        return sum / counting;
    }

    // The mean of the pictures' relMSE.
    double relativeError(const Exr& reference) const {
        support::RunningMean error;
        for (const auto& picture : pictures_)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    if (reference.at("A", x, y) < 0.5f) continue;
                    for (const char* channel : {"R", "G", "B"}) {
                        const double there = reference.at(channel, x, y), off = picture->at(channel, x, y) - there;
                        error.add(off * off / (there * there + 0.01));
                    }
                }
        return error.mean();
    }

private:
    std::vector<std::unique_ptr<Exr>> pictures_;
};

class ConvergedPicture : public testing::TestWithParam<Converged> {};

TEST_P(ConvergedPicture, IsMet) {
    const Converged& picture = GetParam();
    const Renders renders(picture);
    const Exr reference(std::string(GRSH_REFERENCE "/") + picture.name + ".exr");
    for (const char* channel : {"R", "G", "B"})
        EXPECT_NEAR(
            renders.mean(reference, channel, whole).mean() / Renders::meanOf(reference, reference, channel, whole), 1,
            picture.tolerance)
            << channel;

    // All channels together: of the darkest alone a reference has noise, too.
    for (int top = 0; top < size; top += blockSize)
        for (int left = 0; left < size; left += blockSize) {
            const Area block{left, top, left + blockSize, top + blockSize};
            const double there = Renders::meanOf(reference, reference, "RGB", block);
            if (std::isnan(there)) continue;  // all of it lamp
            const support::RunningMean here = renders.mean(reference, "RGB", block);
            EXPECT_LE(std::abs(here.mean() - there), std::max(0.02 * there, farForBlock * here.standardError()))
                << "from (" << left << ", " << top << "): " << here.mean() << " +- " << here.standardError()
                << ", expected " << there;
        }

    EXPECT_LE(renders.relativeError(reference), allowance * picture.noise);
}

// The light grazes it. Rays that start 4 units off their surface make it half a per cent darker, and 5 % if lights are
// asked from there, too. It is seen to fail with both; here it is 0.18 % off at most, and its standard error 0.07 %.
TEST(ConvergedPictureA, ShowsTheTallBoxsFront) {
    constexpr Area front{80, 114, 120, 219};
    const Renders renders(pictures[0]);
    const Exr reference(GRSH_REFERENCE "/a.exr");
    for (const char* channel : {"R", "G", "B"})
        EXPECT_NEAR(
            renders.mean(reference, channel, front).mean() / Renders::meanOf(reference, reference, channel, front), 1,
            0.004)
            << channel;
}

INSTANTIATE_TEST_SUITE_P(Of, ConvergedPicture, testing::ValuesIn(pictures), [](const auto& info) {
    std::string name;
    for (const char c : std::string(info.param.name))
        if (c != '-') name += c;
    return name;
});

}  // namespace
}  // namespace render
