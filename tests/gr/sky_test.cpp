// The sky: drawn with the density that it tells, which is that of its brightness, and seen where its picture has it.
// Seen to fail with rows drawn by their mean instead of their sum with the sine, columns of the row below, the place in
// a cell uniform, a density that forgets the sine, half rows that count for whole ones, a picture that is mirrored,
// upside down, half a turn or half a pixel off, and one that is turned the other way.
#include "gr/sky_pictures.h"
#include "support/histogram.h"
#include "support/quadrature.h"

#include <gtest/gtest.h>

#include "support/test_random.h"

namespace gr {
namespace {

using core::Rgbf;
using core::Vec2f;
using core::Vec3f;

struct Named {
    const char* name;
    SkyGrid grid;
};
std::vector<Named> skies() {
    std::vector<Named> all;
    all.push_back({"smooth", smoothSky()});
    all.push_back({"spotted", spottedSky()});
    all.push_back({"one pixel", skyOf(1, 1, [](double, double) { return Rgbf(2, 3, 4); })});
    all.push_back({"a line", skyOf(5, 1, [](double u, double) { return Rgbf(static_cast<float>(u)); })});
    all.push_back({"a column", skyOf(1, 3, [](double, double v) { return Rgbf(static_cast<float>(v)); })});
    return all;
}

TEST(SkyGrid, DrawsWithTheDensityThatItTells) {
    for (const Named& sky : skies()) {
        support::TestRandom random(1);
        support::SquareHistogram histogram(47, 31);
        for (int i = 0; i < 1'000'000; ++i) {
            const auto place = sky.grid.draw(Vec2f(random.next(), random.next()));
            histogram.add(place.u, place.v);
            if (i >= 1000) continue;
            const auto seen = sky.grid.at(place.u, place.v);
            EXPECT_NEAR(seen.density, place.density, 2e-3 * place.density + 2e-4) << sky.name;
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(seen.radiance[c], place.radiance[c], 2e-3 * place.radiance[c] + 1e-5) << sky.name;
        }
        const auto result = histogram.test([&](double u, double v) {
            return double{sky.grid.at(static_cast<float>(u), static_cast<float>(v)).density};
        });
        EXPECT_TRUE(result.accepted) << sky.name << ": " << result.text;
        EXPECT_NEAR(result.integral, 1, 1e-3) << sky.name;
    }
}

// As a direction, over solid angle.
TEST(SkyLight, DrawsDirectionsWithTheDensityThatItTells) {
    const SkyGrid grid = smoothSky();
    for (const double turns : {0., 0.37}) {
        const SkyLight light = lightOf(grid, turns);
        support::TestRandom random(2);
        support::SphereHistogram histogram;
        // About +y, which the histogram calls z.
        for (int i = 0; i < 1'000'000; ++i) {
            const auto sample = light.sample(Vec3f(0), Vec2f(random.next(), random.next()));
            histogram.add(sample.wi.z, sample.wi.x, sample.wi.y);
        }
        const auto result = histogram.test(
            [&](double x, double y, double z) { return double{light.seen(Vec3f(glm::vec3(y, z, x))).pdfW}; });
        EXPECT_TRUE(result.accepted) << turns << ": " << result.text;
        EXPECT_NEAR(result.integral, 1, 1e-3);
    }
}

// What a sample brings is what is seen there, over the density.
TEST(SkyLight, BringsWhatIsSeen) {
    const SkyGrid grid = smoothSky();
    const SkyLight light = lightOf(grid, 0.2);
    support::TestRandom random(3);
    for (int i = 0; i < 10'000; ++i) {
        const auto sample = light.sample(Vec3f(1, 2, 3), Vec2f(random.next(), random.next()));
        ASSERT_NEAR(glm::length(sample.wi), 1, 1e-6);
        const auto seen = light.seen(sample.wi);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(sample.weight[c] * sample.pdfW, seen.radiance[c], 1e-3 * seen.radiance[c] + 1e-4);
        ASSERT_NEAR(sample.pdfW, seen.pdfW, 2e-3 * seen.pdfW);
        // In proportion to the brightness, but for the bend of the sine within a line.
        const double share = (seen.radiance.x + seen.radiance.y + seen.radiance.z) / seen.pdfW;
        ASSERT_NEAR(share / (12 * M_PI * grid.mean() * grid.unit()), 1, 0.03);
    }
}

TEST(SkyLight, NothingIsLostOfWhatIsBright) {
    const SkyGrid grid = spottedSky();
    const SkyLight light = lightOf(grid);
    support::TestRandom random(4);
    for (int i = 0; i < 100'000; ++i) {
        const float v = random.next(), turns = random.next();
        const float sine = std::sin(core::pi * v);
        const Vec3f wi(sine * std::sin(2 * core::pi * turns), std::cos(core::pi * v),
                       sine * std::cos(2 * core::pi * turns));
        const auto seen = light.seen(wi);
        if (seen.radiance.x > 1e-3f) {
            ASSERT_GT(seen.pdfW, 0);
        }
    }
}

// A mark in each of six directions, as the picture has them: its middle towards -z, its right half towards +x.
TEST(SkyLight, LooksLikeItsPictureFromWithin) {
    const Rgbf marks[6] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
    std::vector<Rgbf> picture(64 * 32, Rgbf(0.1f));
    const auto mark = [&](int left, int right, int top, int bottom, const Rgbf& colour) {
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) picture[static_cast<std::size_t>(y * 64 + x)] = colour;
    };
    mark(28, 36, 12, 20, marks[0]);  // the middle
    mark(44, 52, 12, 20, marks[1]);  // right of it
    mark(12, 20, 12, 20, marks[2]);  // left of it
    mark(0, 4, 12, 20, marks[3]);  // the edges
    mark(60, 64, 12, 20, marks[3]);
    mark(0, 64, 0, 4, marks[4]);  // above
    mark(0, 64, 28, 32, marks[5]);  // below
    const SkyGrid grid(64, 32, std::move(picture));
    const Vec3f directions[6] = {{0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, -1, 0}};
    for (int i = 0; i < 6; ++i) EXPECT_EQ(lightOf(grid).seen(directions[i]).radiance, marks[i]) << i;
    // A quarter turn, counterclockwise from above, takes what is in front to the left.
    const int from[6] = {1, 3, 0, 2, 4, 5};
    for (int i = 0; i < 6; ++i) EXPECT_EQ(lightOf(grid, 0.25).seen(directions[i]).radiance, marks[from[i]]) << i;
}

// Between the middles of pixels it goes straight, round the edge, too.
TEST(SkyGrid, IsBilinear) {
    const SkyGrid grid = skyOf(4, 2, [](double u, double v) { return Rgbf(static_cast<float>(v < 0.5 ? u : 8 * u)); });
    const auto at = [&](double u, double v) {
        return grid.at(static_cast<float>(u), static_cast<float>(v)).radiance.x * grid.unit();
    };
    EXPECT_NEAR(at(0.125, 0.25), 0.125, 1e-6);
    EXPECT_NEAR(at(0.25, 0.25), 0.25, 1e-6);
    EXPECT_NEAR(at(0.25, 0.1), 0.25, 1e-6);  // above the first line
    EXPECT_NEAR(at(0.25, 0.5), (0.25 + 2) / 2, 1e-5);
    EXPECT_NEAR(at(0, 0.25), 0.5, 1e-6);  // between the last and the first
    EXPECT_NEAR(at(1, 0.25), 0.5, 1e-6);
    EXPECT_NEAR(at(0.9375, 0.25), (0.875 * 3 + 0.125) / 4, 1e-6);
}

TEST(SkyLight, ToldMeanAgreesWithQuadrature) {
    const SkyGrid grid = smoothSky();
    const SkyLight light = lightOf(grid);
    // A pixel's mean is its middle's, but for bends: a fine rule over the sphere.
    double sum = 0;
    constexpr int lines = 400;
    for (int y = 0; y < lines; ++y)
        for (int x = 0; x < 2 * lines; ++x) {
            const double height = 2 * (y + 0.5) / lines - 1, turn = M_PI * (x + 0.5) / lines;
            const double radius = std::sqrt(1 - height * height);
            const Rgbf c =
                light.seen(Vec3f(glm::dvec3(radius * std::sin(turn), height, radius * std::cos(turn)))).radiance;
            sum += (double{c.x} + c.y + c.z) / 3;
        }
    EXPECT_NEAR(light.power(), M_PI * sum / (2. * lines * lines), 0.01 * light.power());
}

// Its own part of what there is, whatever a script calls bright.
TEST(SkyGrid, IsTheSameInEveryUnit) {
    for (const float scale : {1e-20f, 1e18f}) {
        const SkyGrid grid = skyOf(4, 2, [&](double u, double v) { return Rgbf(static_cast<float>(u * v)) * scale; });
        const SkyLight light = lightOf(grid);
        const auto seen = light.seen(Vec3f(0.6f, 0, 0.8f));
        EXPECT_TRUE(std::isfinite(seen.radiance.x) && seen.radiance.x > 0.01f * scale && seen.radiance.x < scale);
        const auto sample = light.sample(Vec3f(0), Vec2f(0.3f, 0.6f));
        EXPECT_TRUE(sample.weight.x > 0 && std::isfinite(sample.weight.x) && sample.pdfW > 0);
    }
}

}  // namespace
}  // namespace gr
