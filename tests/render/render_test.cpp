// From an integrator to a film: what must not change a picture, and what must.
#include "render/render.h"

#include "core/parallel.h"
#include "render/test_scene.h"

#include <gtest/gtest.h>

namespace render {
namespace {

constexpr int width = 37;  // no multiple of a tile
constexpr int height = 29;
const Camera camera({0, 0, 6}, {0.05, -0.1, -1}, {0, 1, 0}, 50, width, height);

Camera lens(double radius) {
    Camera lens = camera;
    lens.setLens(radius, 5);
    return lens;
}

struct Picture {
    std::vector<core::Rgbf> pixels;
    RenderResult result;
    std::uint64_t progressSamples, progressRays;
};

Picture renderLines(const Integrator& integrator, const RenderSettings& settings, int startLine = 0, int lines = height,
                    const Camera& camera = render::camera) {
    image::Film film(width, height, startLine, lines);
    Progress progress;
    const std::atomic<bool> stop = false;
    Picture picture;
    picture.result = render(integrator, camera, settings, film, progress, stop);
    picture.progressSamples = progress.samples;
    picture.progressRays = progress.rays;
    for (int y = startLine; y < startLine + lines; ++y)
        for (int x = 0; x < width; ++x) picture.pixels.push_back(film.at(x, y));
    return picture;
}

// Everything that draws random numbers.
class Rendering : public testing::Test {
protected:
    Rendering() {
        scene.add("room", gr::BoxNode{{-2, -2, -2}, {4, 4, 12}}, core::Rgbf(0.8f, 0.6f, 0.4f));
        scene.add("ball", gr::SphereNode{{0.5, -1, 0}, 0.9}, core::Rgbf(0.5f));
        scene.addAreaLight("lamp", core::Rgbf(9, 8, 7), {0, 1.9, 0}, 1.5);
        settings.globalIllumination = true;
        settings.antialiasing = true;
        settings.pathLength = 3;
        settings.samplesPerPixel = 6;
        settings.samplesPerLightSource = 2;
        settings.seed = 11;
    }
    Picture rendered(int startLine = 0, int lines = height) { return renderedBy(camera, startLine, lines); }
    Picture renderedBy(const Camera& camera, int startLine = 0, int lines = height) {
        scene.settings = settings;
        return renderLines(Radiometer(scene, {0, 0, 6}).integrator(), settings, startLine, lines, camera);
    }
    // A ball of steel, two of glass, one in the other, and a pane that cuts the lens in two.
    void addEveryMaterial() {
        using materials::Dielectric;
        scene.add("steel", gr::SphereNode{{-1, -1, 1}, 0.8},
                  materials::Shirley{.exponents = {10, 300}, .sampling = core::Weights{0.2f, 0.3f, 0, 0.5f}});
        scene.add("glass", gr::SphereNode{{0.3, 0.4, 2}, 0.7}, Dielectric{.absorption = {0.1f, 0.6f, 0.3f}});
        scene.add("drop", gr::SphereNode{{0.3, 0.4, 2.2}, 0.4},
                  Dielectric{.specular = core::Rgbf(0.3f), .index = 1.3, .perturbation = 3});
        scene.add("visor", gr::BoxNode{{0.03, -0.5, 5.5}, {0.5, 0.9, 1}}, Dielectric{.absorption = {0.5f, 0, 0}});
    }

    TestScene scene;
    RenderSettings settings;
};

TEST_F(Rendering, IsTheSameToTheBitOnAnyNumberOfThreads) {
    settings.threads = 1;
    const Picture one = rendered();
    for (const int threads : {2, 3, 7, 0}) {
        settings.threads = threads;
        const Picture many = rendered();
        EXPECT_EQ(many.pixels, one.pixels) << threads << " threads";
        EXPECT_EQ(many.result.rays.total(), one.result.rays.total());
        EXPECT_EQ(many.result.threads, core::threadCount(threads));
    }
}

TEST_F(Rendering, IsTheSameToTheBitInStrips) {
    const Picture whole = rendered();
    const std::vector<std::vector<int>> cuts = {{height}, {1, height - 1}, {16, 13}, {7, 1, 15, 6}};
    for (const std::vector<int>& lines : cuts) {
        Picture strips;
        std::uint64_t rays = 0;
        int start = 0;
        for (const int count : lines) {
            const Picture strip = rendered(start, count);
            strips.pixels.insert(strips.pixels.end(), strip.pixels.begin(), strip.pixels.end());
            rays += strip.result.rays.total();
            start += count;
        }
        EXPECT_EQ(strips.pixels, whole.pixels) << lines.size() << " strips";
        EXPECT_EQ(rays, whole.result.rays.total());
    }
}

TEST_F(Rendering, OfEveryMaterialThroughALensIsTheSameToTheBit) {
    addEveryMaterial();
    settings.threads = 1;
    settings.pathLength = 6;
    const Camera camera = lens(0.2);
    const Picture one = renderedBy(camera);
    settings.threads = 5;
    const Picture many = renderedBy(camera);
    EXPECT_EQ(many.pixels, one.pixels);
    EXPECT_EQ(many.result.rays.refractive, one.result.rays.refractive);
    EXPECT_GT(many.result.rays.refractive, 100u);
    EXPECT_EQ(many.result.droppedSamples, 0u);
    Picture strips;
    for (const auto& [start, lines] : {std::pair(0, 13), {13, 1}, {14, height - 14}}) {
        const Picture strip = renderedBy(camera, start, lines);
        strips.pixels.insert(strips.pixels.end(), strip.pixels.begin(), strip.pixels.end());
    }
    EXPECT_EQ(strips.pixels, one.pixels);
}

TEST_F(Rendering, ThroughALensWithoutWidthIsThatOfAPinhole) {
    addEveryMaterial();
    EXPECT_EQ(renderedBy(lens(0)).pixels, rendered().pixels);
    EXPECT_NE(renderedBy(lens(0.01)).pixels, rendered().pixels);
}

TEST_F(Rendering, DiffersWithAnotherSeed) {
    const Picture first = rendered();
    for (const std::uint64_t seed : {std::uint64_t{12}, std::uint64_t{11} + (std::uint64_t{1} << 32)}) {
        settings.seed = seed;
        const Picture second = rendered();
        int same = 0;
        for (std::size_t i = 0; i < first.pixels.size(); ++i) same += first.pixels[i] == second.pixels[i] ? 1 : 0;
        EXPECT_LT(same, width * height / 20) << "all but the lamp itself has noise";
    }
}

// The first n samples of many are the n samples of few.
TEST_F(Rendering, GivesEverySampleItsOwnNumber) {
    settings.antialiasing = false;
    scene.settings = settings;
    const Radiometer radiometer(scene);
    const Picture picture = renderLines(radiometer.integrator(), settings);
    const core::Rayf ray = camera.ray(core::Vec2f(20.5f, 9.5f));
    glm::dvec3 sum(0);
    for (int i = 0; i < settings.mostSamples(); ++i) {
        Sampler sampler(settings.seed, 20, 9, i);
        sampler.next2D();  // the place in the pixel
        RayCounts rays;
        sum += glm::dvec3(radiometer.integrator().radiance(ray, sampler, rays));
    }
    EXPECT_EQ(picture.pixels[9 * width + 20], core::Rgbf(sum / double(settings.mostSamples())));
}

TEST_F(Rendering, SaysWhatItDid) {
    const Picture picture = rendered(3, 20);
    const std::uint64_t samples = std::uint64_t{20} * width * 6;
    EXPECT_EQ(picture.result.samples, samples);
    EXPECT_EQ(picture.result.rays.camera, samples);
    EXPECT_EQ(picture.result.droppedSamples, 0u);
    EXPECT_EQ(picture.progressSamples, samples);
    EXPECT_EQ(picture.progressRays, picture.result.rays.total());
}

}  // namespace
}  // namespace render
