// What a film with layers holds, and what layers must not change.
// Seen to fail with samples that are not finite kept, the variance of a sample in place of the mean's, with n for n - 1
// in it, and layers of another pixel.
#include "render/layer_picture.h"

#include <gtest/gtest.h>

#include <map>
#include <mutex>

namespace render {
namespace {

using core::Rgbf;
using core::Vec3f;

constexpr int width = 37, height = 29;  // no multiple of a tile
const Camera camera({0, 0, 6}, {0.05, -0.1, -1}, {0, 1, 0}, 50, width, height);

struct Sample {
    Rgbf radiance;
    FirstSurface first;
    float depth;
};

// Random radiance and surfaces; some samples are not finite, and some meet nothing. It keeps what it gave, by
// direction.
class Told : public ScalarIntegrator {
public:
    Rgbf radiance(const core::Rayf& ray, Sampler& sampler, RayCounts&, FirstSurface* first) const override {
        Sample sample;
        for (int c = 0; c < 3; ++c) sample.radiance[c] = 100 + sampler.next1D();
        if (sampler.next1D() < 0.6f) {
            const core::Vec2f a = sampler.next2D(), b = sampler.next2D();
            sample.first = {1 + sampler.next1D(), Rgbf(a.x, a.y, b.x), Vec3f(b.y, -a.x, a.y)};
        }
        if (sampler.next1D() < 0.1f) sample.radiance.y = std::nanf("");
        sample.depth = camera.depth(ray, sample.first.distance);
        const std::lock_guard lock(mutex_);
        EXPECT_NE(first, nullptr);
        *first = sample.first;
        given[{ray.direction.x, ray.direction.y}].push_back(sample);
        return sample.radiance;
    }

    mutable std::map<std::pair<float, float>, std::vector<Sample>> given;

private:
    mutable std::mutex mutex_;
};

// Two passes, in double.
glm::dvec3 varianceOfMean(const std::vector<Sample>& kept) {
    const double n = double(kept.size());
    glm::dvec3 mean(0), squares(0);
    for (const Sample& sample : kept) mean += glm::dvec3(sample.radiance) / n;
    for (const Sample& sample : kept) squares += glm::pow(glm::dvec3(sample.radiance) - mean, glm::dvec3(2));
    return squares / (n - 1) / n;
}

TEST(FilmLayers, AreMadeOfThePixelsFiniteSamples) {
    RenderSettings settings;
    settings.samplesPerPixel = 7;
    const Told integrator;
    const image::Film film = layersOf(integrator, camera, settings, image::Film(width, height, 0, height, everyLayer));
    int dropped = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const core::Rayf ray = camera.ray(core::Vec2f(x + 0.5f, y + 0.5f));
            std::vector<Sample> kept = integrator.given.at({ray.direction.x, ray.direction.y});
            ASSERT_EQ(kept.size(), 7u);
            std::erase_if(kept, [](const Sample& sample) { return !core::isFinite(sample.radiance); });
            dropped += 7 - int(kept.size());
            glm::dvec3 albedo(0), normal(0);
            double depth = 0;
            int met = 0;
            for (const Sample& sample : kept) {
                albedo += glm::dvec3(sample.first.albedo) / double(kept.size());
                normal += glm::dvec3(sample.first.normal) / double(kept.size());
                if (!sample.first.isMet()) continue;
                depth += double(sample.depth);
                ++met;
            }
            ASSERT_EQ(numberAt(film, image::Layer::samples, x, y), kept.size());
            ASSERT_LT(glm::distance(glm::dvec3(vectorAt(film, image::Layer::albedo, x, y)), albedo), 1e-6);
            ASSERT_LT(glm::distance(glm::dvec3(vectorAt(film, image::Layer::normal, x, y)), normal), 1e-6);
            if (met > 0)
                ASSERT_NEAR(numberAt(film, image::Layer::depth, x, y), depth / met, 1e-6);
            else
                ASSERT_EQ(numberAt(film, image::Layer::depth, x, y), core::infinity);
            const glm::dvec3 variance = varianceOfMean(kept);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(vectorAt(film, image::Layer::variance, x, y)[c], variance[c], 1e-6 * variance[c]);
        }
    }
    EXPECT_GT(dropped, 500);
}

// Everything that draws random numbers.
struct Room : TestScene {
    Room() {
        add("room", gr::BoxNode{{-2, -2, -2}, {4, 4, 12}}, Rgbf(0.8f, 0.6f, 0.4f));
        add("steel", gr::SphereNode{{0.5, -1, 0}, 0.9}, materials::Shirley{.exponents = {10, 300}});
        add("glass", gr::SphereNode{{-0.6, 0.4, 2}, 0.7}, materials::Dielectric{.absorption = {0.1f, 0.6f, 0.3f}});
        addAreaLight("lamp", Rgbf(9, 8, 7), {0, 1.9, 0}, 1.5);
        settings.globalIllumination = true;
        settings.antialiasing = true;
        settings.pathLength = 4;
        settings.samplesPerPixel = 6;
    }
};

std::vector<float> numbersOf(const image::Film& film) {
    std::vector<float> numbers;
    for (int y = film.startLine(); y < film.startLine() + film.lines(); ++y)
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) numbers.push_back(film.at(x, y)[c]);
            for (const image::Layer layer : everyLayer)
                for (const float number : film.at(layer, x, y)) numbers.push_back(number);
        }
    return numbers;
}

TEST(FilmLayers, AreTheSameToTheBitOnAnyNumberOfThreadsAndInStrips) {
    Room scene;
    const Radiometer radiometer(scene, {0, 0, 6});
    const auto numbers = [&](int threads, int startLine, int lines) {
        scene.settings.threads = threads;
        return numbersOf(layersOf(radiometer.integrator(), camera, scene.settings,
                                  image::Film(width, height, startLine, lines, everyLayer)));
    };
    const std::vector<float> whole = numbers(1, 0, height);
    EXPECT_EQ(numbers(5, 0, height), whole);
    std::vector<float> strips = numbers(2, 0, 13);
    for (const float number : numbers(2, 13, height - 13)) strips.push_back(number);
    EXPECT_EQ(strips, whole);
}

TEST(FilmLayers, DoNotChangeTheRadiance) {
    const Room scene;
    const Radiometer radiometer(scene, {0, 0, 6});
    const image::Film with =
        layersOf(radiometer.integrator(), camera, scene.settings, image::Film(width, height, 0, height, everyLayer));
    const image::Film without =
        layersOf(radiometer.integrator(), camera, scene.settings, image::Film(width, height, 0, height));
    EXPECT_FALSE(without.hasLayers());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) ASSERT_EQ(with.at(x, y), without.at(x, y));
}

// Integrators need not find out what nobody asked for.
class NotAsked : public ScalarIntegrator {
    Rgbf radiance(const core::Rayf&, Sampler&, RayCounts&, FirstSurface* first) const override {
        return Rgbf(first == nullptr ? 1.f : 0.f);
    }
};

TEST(FilmLayers, AreNotAskedForWithoutNeed) {
    EXPECT_EQ(layersOf(NotAsked(), camera, {}, image::Film(width, height, 0, height)).at(3, 4), Rgbf(1));
}

TEST(FilmLayers, HoldWhatWasAskedForAlone) {
    const std::array<image::Layer, 2> some{image::Layer::samples, image::Layer::normal};
    const Room scene;
    const image::Film film = layersOf(Radiometer(scene, {0, 0, 6}).integrator(), camera, scene.settings,
                                      image::Film(width, height, 0, height, some));
    EXPECT_TRUE(film.hasLayers());
    for (const image::Layer layer : {image::Layer::albedo, image::Layer::depth, image::Layer::variance})
        EXPECT_TRUE(film.at(layer, 3, 4).empty());
    EXPECT_EQ(numberAt(film, image::Layer::samples, 3, 4), 6);
    EXPECT_NEAR(glm::length(vectorAt(film, image::Layer::normal, 36, 28)), 1, 1e-5);
}

TEST(FilmLayers, HaveTheirBytesCounted) {
    const auto bytes = [](std::span<const image::Layer> layers) {
        EXPECT_EQ(static_cast<double>(image::Film(7, 90, 11, 5, layers).bytes()), image::Film::bytesFor(7, 5, layers));
        return image::Film::bytesFor(7, 5, layers) / 35;
    };
    EXPECT_EQ(bytes({}), 12);
    EXPECT_EQ(bytes(everyLayer), 12 + 4 * 11);
    EXPECT_EQ(bytes(std::array{image::Layer::depth}), 16);
    EXPECT_EQ(bytes(std::array{image::Layer::variance}), 24);
    EXPECT_EQ(image::Film::bytesFor(1'000'000, 1'000'000, everyLayer), 56e12);
}

}  // namespace
}  // namespace render
