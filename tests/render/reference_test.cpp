// A picture against a reference made of other random numbers: every pixel and the whole must agree.
// Seen to fail with a seed that is ignored, the same random numbers in all pixels, a mean over one sample too few, and
// a lamp 2 % too bright.
#include "render/render.h"

#include "render/test_scene.h"
#include "support/image_comparison.h"

#include <gtest/gtest.h>

namespace render {
namespace {

constexpr int size = 16;
constexpr std::size_t pixels = std::size_t{size} * size;
constexpr int referenceSamples = 32;
constexpr int references = 256;

// A channel's values, pixel after pixel.
using Values = std::vector<double>;
using Channels = std::array<Values, 3>;

// A Cornell box: a lamp, two coloured walls, a block, light over three points.
class CornellBox {
public:
    explicit CornellBox(float brightness) {
        scene_.add("room", gr::BoxNode{{-1, -1, -1}, {2, 2, 2}}, core::Rgbf(0.7f));
        scene_.addPolygon("red", {{-0.99, -1, -1}, {-0.99, 1, -1}, {-0.99, 1, 1}, {-0.99, -1, 1}},
                          core::Rgbf(0.65f, 0.05f, 0.05f));
        scene_.addPolygon("green", {{0.99, -1, -1}, {0.99, 1, -1}, {0.99, 1, 1}, {0.99, -1, 1}},
                          core::Rgbf(0.12f, 0.45f, 0.15f));
        scene_.add("block", gr::BoxNode{{0, -1, -0.4}, {0.5, 0.7, 0.5}}, core::Rgbf(0.7f));
        scene_.addAreaLight("lamp", core::Rgbf(9, 8, 6) * brightness, {0, 0.98, 0}, 0.8);
        scene_.settings.globalIllumination = true;
        scene_.settings.antialiasing = true;
        scene_.settings.pathLength = 3;
        radiometer_ = std::make_unique<Radiometer>(scene_);
    }

    // From where the lamp itself, which has no noise, is out of the picture.
    Channels picture(std::uint64_t seed, int samples) const {
        RenderSettings settings = scene_.settings;
        settings.seed = seed;
        settings.samplesPerPixel = samples;
        const Camera camera({0, 0, 0.95}, {0, 0, -1}, {0, 1, 0}, 60, size, size);
        image::Film film(size, size, 0, size);
        Progress progress;
        const std::atomic<bool> stop = false;
        render(radiometer_->integrator(), camera, settings, film, progress, stop);
        Channels channels;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (int c = 0; c < 3; ++c) channels[static_cast<std::size_t>(c)].push_back(film.at(x, y)[c]);
        return channels;
    }

private:
    TestScene scene_;
    std::unique_ptr<Radiometer> radiometer_;
};

// The mean of many renders, and the variance of one sample that they show.
class Reference {
public:
    Reference() {
        const CornellBox box(1);
        for (std::uint64_t seed = 1; seed <= references; ++seed) {
            const Channels picture = box.picture(seed, referenceSamples);
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t i = 0; i < pixels; ++i) values_[c][i].add(picture[c][i]);
        }
    }
    support::ImageComparison compare(const Channels& picture, std::size_t channel, int samples) const {
        Values variance, mean;
        for (const support::RunningMean& value : values_[channel]) {
            mean.push_back(value.mean());
            const double ofSample = value.variance() * referenceSamples;
            variance.push_back(ofSample / samples + ofSample / (referenceSamples * references));
        }
        return support::compareImages(picture[channel], variance, mean);
    }

private:
    std::array<std::array<support::RunningMean, pixels>, 3> values_;
};

TEST(ReferencePicture, IsMetInEveryPixelAndOnTheWhole) {
    constexpr int samples = 1000;
    const Reference reference;
    const Channels picture = CornellBox(1).picture(0, samples);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const support::ImageComparison result = reference.compare(picture, channel, samples);
        EXPECT_TRUE(result.accepted) << "channel " << channel << ": " << result.text;
    }

    // No pixel shows a lamp that is 2 % too bright: that is less than its noise. The whole does.
    const support::ImageComparison tooBright = reference.compare(CornellBox(1.02f).picture(0, samples), 0, samples);
    EXPECT_TRUE(tooBright.pixels.accepted) << tooBright.text;
    EXPECT_FALSE(tooBright.mean.accepted) << tooBright.text;
    EXPECT_FALSE(tooBright.accepted);
}

}  // namespace
}  // namespace render
