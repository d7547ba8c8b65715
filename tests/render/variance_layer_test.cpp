// The variance layer against the variance of pixels over many seeds.
// Seen to fail with a variance 10 % too large or too small, of a sample in place of the mean, and with n for n - 1.
#include "render/layer_picture.h"

#include <gtest/gtest.h>

namespace render {
namespace {

// The pixels of one picture are as independent as those of many: each has random numbers of its own, and all show the
// same place, in the lamp's half shadow. Without antialiasing their samples are independent, too.
TEST(VarianceLayer, IsThatOfPixelsOverManySeeds) {
    TestScene scene;
    scene.add("floor", gr::BoxNode{{-50, -1, -50}, {100, 1, 100}}, core::Rgbf(0.8f, 0.5f, 0.2f));
    scene.add("edge", gr::BoxNode{{0.1, 1, -50}, {50, 1, 100}}, core::Rgbf(0.9f));
    scene.addAreaLight("lamp", core::Rgbf(9, 8, 7), {0, 3, 0}, 2);
    scene.settings.globalIllumination = true;
    scene.settings.samplesPerPixel = 4;
    const Radiometer radiometer(scene);
    // So far up that all pixels see one place.
    const int size = 180;
    const Camera camera({-0.3, 0.9, 0}, {0, -1, 0}, {0, 0, 1}, 1e-5, size, size);
    const image::Film film =
        layersOf(radiometer.integrator(), camera, scene.settings, image::Film(size, size, 0, size, everyLayer));

    for (int channel = 0; channel < 3; ++channel) {
        support::RunningMean pixels;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) pixels.add(double(film.at(x, y)[channel]));
        // For each pixel: how far it is from the mean of all, squared, less what the layer says of it.
        const double bias = double(pixels.count()) / (double(pixels.count()) - 1);
        support::RunningMean difference, layer;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const double deviation = double(film.at(x, y)[channel]) - pixels.mean();
                const double variance =
                    double(film.at(image::Layer::variance, x, y)[static_cast<std::size_t>(channel)]);
                difference.add(deviation * deviation * bias - variance);
                layer.add(variance);
            }
        const support::TestResult result = support::zTest(difference, 0);
        EXPECT_TRUE(result.accepted) << result.text;
        EXPECT_LT(difference.standardError(), 0.02 * layer.mean()) << "it could not tell 10 % from nothing";
    }
}

}  // namespace
}  // namespace render
