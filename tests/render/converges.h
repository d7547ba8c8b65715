// Whether a noisy measurement comes to what the maths says: within 3 standard errors and 0.3 %.
#pragma once

#include "render/test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace render {

// What is wrong with a mean; text is empty where nothing is.
struct Deviation {
    double score = 0;  // standard errors
    std::string text;

    Deviation(const support::RunningMean& mean, double expected)
        : score(std::abs(support::zScore(mean.mean(), mean.standardError(), expected))) {
        std::ostringstream fault;
        fault.precision(9);
        fault << mean.mean() << " +- " << mean.standardError() << ", expected " << expected << ": ";
        // With more noise than this the test could not tell 0.3 % from nothing.
        if (mean.standardError() > 1e-3 * expected)
            fault << "too few samples";
        else if (score > 3)
            fault << score << " standard errors off";
        else if (std::abs(mean.mean() - expected) > 3e-3 * expected)
            fault << "more than 0.3 % off";
        else
            return;
        text = fault.str();
    }
};

// The deviation of the channel that is off most.
inline Deviation deviation(const RgbMean& mean, const glm::dvec3& expected) {
    Deviation worst(mean[0], expected[0]);
    for (int channel = 1; channel < 3; ++channel) {
        const Deviation other(mean[channel], expected[channel]);
        const bool isWorse = other.text.empty() == worst.text.empty() ? other.score > worst.score : worst.text.empty();
        if (isWorse) worst = other;
    }
    return worst;
}

// The samples that bring every channel's standard error to 0.1 %, by what a few of them vary.
inline int samplesFor(const Radiometer& radiometer, const core::Rayf& ray) {
    double needed = 1000;
    for (const support::RunningMean& mean : radiometer.measure(ray, 20'000, 0)) {
        const double relative = std::sqrt(mean.variance()) / mean.mean();
        if (relative > 0) needed = std::max(needed, std::pow(relative / 0.95e-3, 2));
    }
    return static_cast<int>(std::min(needed, 4e7));
}

// A right mean is off by more than 3 standard errors once in 370 times, and there are many tests. So what fails is
// measured anew, with 16 times the samples and other random numbers: an error is 4 times as many standard errors then,
// and chance fails twice in a row less than once in 100,000 times. It is never off by 8.
inline testing::AssertionResult converges(const Radiometer& radiometer, const core::Rayf& ray,
                                          const glm::dvec3& expected) {
    const int samples = samplesFor(radiometer, ray);
    const Deviation first = deviation(radiometer.measure(ray, samples, 1), expected);
    if (first.text.empty()) return testing::AssertionSuccess();
    if (first.score > 8) return testing::AssertionFailure() << first.text;
    const Deviation second = deviation(radiometer.measure(ray, 16 * samples, 2), expected);
    if (second.text.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << second.text;
}

// To what single precision leaves of the place on a floor of 20 units.
inline testing::AssertionResult isNear(const core::Rgbf& radiance, const glm::dvec3& expected) {
    for (int channel = 0; channel < 3; ++channel)
        if (!(std::abs(radiance[channel] - expected[channel]) <= 1e-4 * expected[channel]))
            return testing::AssertionFailure()
                   << "channel " << channel << ": " << radiance[channel] << ", expected " << expected[channel];
    return testing::AssertionSuccess();
}

// For light without noise, which every path brings alike. Where little is left of it the path integrator ends some by
// Russian roulette, and the others count for them: then it is in the mean.
inline testing::AssertionResult brings(const Radiometer& radiometer, const core::Rayf& ray, const glm::dvec3& expected,
                                       int paths) {
    testing::AssertionResult result = testing::AssertionSuccess();
    for (int path = 0; path < paths && result; ++path) result = isNear(radiometer.sample(ray, 1, path), expected);
    return result || Radiometer::measuresWith == "report" ? result : converges(radiometer, ray, expected);
}

// Whether any of many paths brings light.
inline bool seesLight(const Radiometer& radiometer, const core::Rayf& ray) {
    for (int path = 0; path < 300; ++path)
        if (radiometer.sample(ray, 1, path) != core::Rgbf(0)) return true;
    return false;
}

}  // namespace render
