// How noisy a picture is, estimated from its own samples; docs/physics.md derives it.
#pragma once

#include "core/vec.h"

#include <optional>
#include <span>

namespace render {

// More samples move the means by what the first were off, less what all still are. Sums over pixels and channels.
struct NoiseStep {
    double moved = 0;  // squares of how far, relative to the pixel
    double squares = 0;  // of each pixel's part in it: what chance has to do with the sum

    NoiseStep& operator+=(const NoiseStep& other) {
        moved += other.moved;
        squares += other.squares;
        return *this;
    }
};

// The means of the first and of all samples of each pixel of a rectangle of that width, line after line.
NoiseStep noiseStep(std::span<const core::Rgbf> before, std::span<const core::Rgbf> after, int width);

struct NoiseEstimate {
    double error;  // relative: the root of the relative mean squared error
    double ratio;  // what doubling the samples leaves of the squared error

    // How many samples it takes to come down to a smaller error, from so many.
    double samplesFor(double target, int samples) const;
};

// steps: from 1 to 2 samples, from 2 to 4, and so on, as many as `samples` allow. rest: from the last power of two to
// all, where it is known. pixels: how many they are sums over. Fewer than 4 samples tell nothing.
std::optional<NoiseEstimate> estimateNoise(std::span<const NoiseStep> steps, const std::optional<NoiseStep>& rest,
                                           int samples, double pixels);

}  // namespace render
