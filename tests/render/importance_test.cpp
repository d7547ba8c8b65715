// Two pictures of a shining ball in a box whose materials differ in nothing but `sampling`: the same light, and much
// more noise where bounces take no heed of the highlight.
// Seen to fail with the density of the drawn method in place of the mixture's, a half vector's density without its
// factor 1 / (4 k.h), and half vectors by another exponent.
#include "render/test_scene.h"
#include "render/transport/camera.h"
#include "support/image_comparison.h"

#include <gtest/gtest.h>

namespace render {
namespace {

constexpr int size = 10;
constexpr std::size_t pixels = std::size_t{size} * size;
constexpr int samples = 6'000;
constexpr glm::dvec3 ball{0, -0.3, -0.2}, eye{0, 0, 3.3};
constexpr double radius = 0.6;
const Camera camera(eye, {0, -0.05, -1}, {0, 1, 0}, 35, size, size);

using Picture = std::array<RgbMean, pixels>;

Picture picture(const core::Weights& sampling, std::uint64_t seed) {
    TestScene scene;
    scene.add("room", gr::BoxNode{{-1, -1, -1}, {2, 2, 5}}, core::Rgbf(0.7f));
    scene.addPolygon("red", {{-0.99, -1, -1}, {-0.99, 1, -1}, {-0.99, 1, 1}, {-0.99, -1, 1}},
                     core::Rgbf(0.6f, 0.1f, 0.1f));
    scene.add(
        "ball", gr::SphereNode{ball, radius},
        materials::Shirley{
            .diffuse = core::Rgbf(0.2f), .specular = {0.9f, 0.8f, 0.5f}, .exponents = {60, 60}, .sampling = sampling});
    scene.addPointLight("lamp", {{-0.2, 0.8, 0.6}, {2, 2, 2}, {0.5, 0, 0.5}});
    scene.settings.globalIllumination = true;
    const Radiometer radiometer(scene);

    Picture picture;
    for (int pixel = 0; pixel < size * size; ++pixel) {
        for (int i = 0; i < samples; ++i) {
            Sampler sampler(seed, pixel % size, pixel / size, i);
            RayCounts rays;
            // All through the pixel's centre: how the direct light varies over a pixel is noise of another kind.
            const core::Vec2f place = core::Vec2f(pixel % size, pixel / size) + 0.5f;
            const core::Rgbf radiance = radiometer.integrator().radiance(camera.ray(place), sampler, rays);
            for (std::size_t c = 0; c < 3; ++c)
                picture[static_cast<std::size_t>(pixel)][c].add(radiance[static_cast<int>(c)]);
        }
    }
    return picture;
}

// Whether all of a pixel lies well within the ball's outline.
bool seesTheBall(std::size_t pixel) {
    const auto x = static_cast<float>(pixel % size), y = static_cast<float>(pixel / size);
    for (const core::Vec2f& corner : {core::Vec2f(0, 0), core::Vec2f(1, 0), core::Vec2f(0, 1), core::Vec2f(1, 1)}) {
        const glm::dvec3 direction(camera.ray(core::Vec2f(x, y) + corner).direction);
        if (glm::length(glm::cross(ball - eye, direction)) > 0.9 * radius) return false;
    }
    return true;
}

TEST(ImportanceSampling, LeavesThePictureAndTakesItsNoise) {
    const Picture with = picture({0.3f, 0, 0, 0.7f}, 1), without = picture({1, 0, 0, 0}, 2);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::vector<double> means, variances, others;
        for (std::size_t i = 0; i < pixels; ++i) {
            means.push_back(with[i][channel].mean());
            others.push_back(without[i][channel].mean());
            variances.push_back((with[i][channel].variance() + without[i][channel].variance()) / samples);
        }
        const support::ImageComparison result = support::compareImages(means, variances, others);
        EXPECT_TRUE(result.accepted) << "channel " << channel << ": " << result.text;
    }

    int seen = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!seesTheBall(i)) continue;
        ++seen;
        EXPECT_GT(without[i][0].variance(), 4 * with[i][0].variance()) << "pixel " << i;
    }
    EXPECT_GT(seen, 8);
}

}  // namespace
}  // namespace render
