// Whether a noisy measurement comes to what the maths says: within 3 standard errors and 0.3 %.
#pragma once

#include "render/test_scene.h"

#include <gtest/gtest.h>

namespace render {

// Empty, or what is wrong with a channel.
inline std::string deviation(const support::RunningMean& mean, double expected) {
    const double score = support::zScore(mean.mean(), mean.standardError(), expected);
    std::ostringstream text;
    text.precision(9);
    text << mean.mean() << " +- " << mean.standardError() << ", expected " << expected << ": ";
    // More noise than this, and the test could not tell 0.3 % from nothing.
    if (mean.standardError() > 1e-3 * expected) return text.str() + "too few samples";
    if (std::abs(score) > 3) return text.str() + "z = " + std::to_string(score);
    if (std::abs(mean.mean() - expected) > 3e-3 * expected) return text.str() + "more than 0.3 % off";
    return "";
}

inline std::string deviation(const RgbMean& mean, const glm::dvec3& expected) {
    for (int channel = 0; channel < 3; ++channel) {
        const std::string text = deviation(mean[channel], expected[channel]);
        if (!text.empty()) return "channel " + std::to_string(channel) + ": " + text;
    }
    return "";
}

// The samples that bring every channel's standard error to 0.1 %, by what a few of them vary.
inline int samplesFor(const Radiometer& radiometer, const core::Rayf& ray) {
    double needed = 1000;
    for (const support::RunningMean& mean : radiometer.measure(ray, 20'000, 0)) {
        const double deviation = std::sqrt(mean.variance()) / mean.mean();
        if (deviation > 0) needed = std::max(needed, std::pow(deviation / 0.95e-3, 2));
    }
    return static_cast<int>(std::min(needed, 1e7));
}

// A right mean is off by more than 3 standard errors once in 370 times, and there are many tests. So what fails is
// measured anew, with 16 times the samples and other random numbers: an error is 4 times as many standard errors then,
// and chance fails twice in a row less than once in 100,000 times.
inline testing::AssertionResult converges(const Radiometer& radiometer, const core::Rayf& ray,
                                          const glm::dvec3& expected) {
    const int samples = samplesFor(radiometer, ray);
    if (deviation(radiometer.measure(ray, samples, 1), expected).empty()) return testing::AssertionSuccess();
    const std::string text = deviation(radiometer.measure(ray, 16 * samples, 2), expected);
    if (text.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << text;
}

// For light without noise: to what single precision leaves of the place on a floor of 20 units.
inline testing::AssertionResult isNear(const core::Rgbf& radiance, const glm::dvec3& expected) {
    for (int channel = 0; channel < 3; ++channel)
        if (!(std::abs(radiance[channel] - expected[channel]) <= 1e-4 * expected[channel]))
            return testing::AssertionFailure()
                   << "channel " << channel << ": " << radiance[channel] << ", expected " << expected[channel];
    return testing::AssertionSuccess();
}

}  // namespace render
