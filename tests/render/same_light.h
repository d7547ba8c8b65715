// Whether two integrators find the same light in a scene: a small picture by each, compared pixel by pixel and as a
// whole. GRSH_TEST_RAYS=20 takes 20 times the samples.
#pragma once

#include "gr/random_shapes.h"
#include "render/test_scene.h"
#include "support/image_comparison.h"

#include <gtest/gtest.h>

namespace render {

constexpr int sameLightWidth = 6, sameLightHeight = 4;

// The mean of many pictures of 8 samples a pixel, each of a seed of its own. Samples of one seed are spread evenly on
// purpose, so that they do not tell how much they vary: the pictures do.
class PictureMean {
public:
    PictureMean(const Integrator& integrator, const Camera& camera, bool antialiasing, int pictures,
                std::uint64_t firstSeed) {
        constexpr int samples = 8;
        const SampleBlock block{0, 0, sameLightWidth, sameLightHeight, 0, samples};
        const std::atomic<bool> stop = false;
        for (int i = 0; i < pictures; ++i) {
            Samples found;
            found.radiance.resize(static_cast<std::size_t>(block.size()));
            const auto seed = firstSeed + static_cast<std::uint64_t>(i);
            integrator.render({camera, antialiasing, seed, samples}, block, found, stop);
            for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) {
                glm::dvec3 sum(0);
                for (std::size_t k = 0; k < samples; ++k) sum += glm::dvec3(found.radiance[pixel * samples + k]);
                for (int channel = 0; channel < 3; ++channel)
                    pixels_[pixel][static_cast<std::size_t>(channel)].add(sum[channel] / samples);
            }
        }
    }

    std::vector<double> means(std::size_t channel) const {
        std::vector<double> means;
        for (const RgbMean& pixel : pixels_) means.push_back(pixel[channel].mean());
        return means;
    }
    std::vector<double> variances(std::size_t channel) const {
        std::vector<double> variances;
        for (const RgbMean& pixel : pixels_) variances.push_back(std::pow(pixel[channel].standardError(), 2));
        return variances;
    }

private:
    std::array<RgbMean, sameLightWidth * sameLightHeight> pixels_;
};

// The comparison of the channel that differs most.
inline support::ImageComparison compare(const PictureMean& a, const PictureMean& b) {
    support::ImageComparison worst;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::vector<double> variances = a.variances(channel);
        const std::vector<double> others = b.variances(channel);
        for (std::size_t i = 0; i < variances.size(); ++i) variances[i] += others[i];
        const support::ImageComparison now = support::compareImages(a.means(channel), variances, b.means(channel),
                                                                    support::sidak(support::significance(), 3));
        const bool isWorse =
            std::min(now.pixels.pValue, now.mean.pValue) < std::min(worst.pixels.pValue, worst.mean.pValue);
        if (channel == 0 || isWorse) worst = now;
    }
    return worst;
}

// What is seen from the origin of the view.
struct SameLight {
    TestScene scene;
    glm::dvec3 eye{0, 0, 1.9}, view{0, -0.1, -1};
    Projection projection = Projection::perspective;

    // The means of a hundred pictures are normal but far out in their tails, where a level for many tests lies. So what
    // differs is looked at again, with four times as many pictures of other seeds, and must differ once more.
    testing::AssertionResult holds(int pictures = gr::rayCount(150)) const {
        const gr::Scene compiled =
            gr::compile(scene.database, ":", scene.pointLights, gr::Origin::isTheWorlds, scene.aroundIt);
        const auto accelerator = gr::makeAccelerator(scene.settings.acceleratorName(), compiled, 1);
        const double focus = scene.settings.focalDistance.value_or(1);
        Camera camera({eye, view, {0, 1, 0}, 70, sameLightWidth, sameLightHeight, projection, focus});
        if (scene.settings.depthOfField) camera.setLens(scene.settings.aperture, focus);
        const RayStarts starts = camera.starts();
        const auto report = makeReportIntegrator(compiled, *accelerator, scene.settings, scene.ambient, starts);
        const auto path = makePathIntegrator(compiled, *accelerator, scene.settings, scene.ambient, starts);

        std::string text;
        for (const int factor : {1, 4}) {
            const auto seed = static_cast<std::uint64_t>(1'000'000 * factor);
            const bool antialiasing = scene.settings.antialiasing;
            const auto result = compare({*path, camera, antialiasing, factor * pictures, seed},
                                        {*report, camera, antialiasing, 4 * factor * pictures, seed});
            if (result.accepted) return testing::AssertionSuccess();
            text = result.text;
        }
        return testing::AssertionFailure() << text;
    }
};

}  // namespace render
