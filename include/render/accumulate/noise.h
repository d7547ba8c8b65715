// How noisy a picture is, estimated from its own samples; docs/physics.md derives it.
#pragma once

#include "core/any_order_sum.h"
#include "core/vec.h"

#include <span>
#include <vector>

namespace render {

// More samples move the means by what the first were off, less what all still are. Sums over pixels and channels, which
// the strips of a picture and the picture in one piece have to the bit alike.
struct NoiseStep {
    core::AnyOrderSum moved;  // squares of how far, relative to the pixel
    core::AnyOrderSum squares;  // of each pixel's part in it: what chance has to do with the sum

    // The means of the first and of all samples of pixels side by side in one line. allOverNew: how many times as many
    // samples there are as there are new ones.
    void add(std::span<const core::Rgbf> before, std::span<const core::Rgbf> after, double allOverNew);
    NoiseStep& operator+=(const NoiseStep& other) {
        moved += other.moved;
        squares += other.squares;
        return *this;
    }
};

// How the means of a picture, or of a part, have moved.
struct NoiseSteps {
    std::vector<NoiseStep> doublings;  // from 1 to 2 samples, from 2 to 4, and so on
    NoiseStep rest;  // from the last power of two to all

    // That to so many samples, from the power of two before.
    NoiseStep& to(int samples);
    NoiseSteps& operator+=(const NoiseSteps& other);
};

// What the noise is estimated from.
struct NoiseSums {
    NoiseStep before, last;  // the last two doublings
    std::optional<core::AnyOrderSum> rest;  // how far the rest has moved, where that is known

    // isWhole: whether all pixels have had the rest. At least 4 samples, which take two doublings.
    NoiseSums(const NoiseSteps& steps, int samples, bool isWhole);
    // From the text that a strip's file has of them. Throws nothing, and has nothing for what is no such text.
    static std::optional<NoiseSums> fromText(std::string_view text);
    std::string text() const;
    NoiseSums& operator+=(const NoiseSums& other);

private:
    NoiseSums() = default;
};

struct NoiseEstimate {
    double error;  // relative: the root of the relative mean squared error
    double ratio;  // what doubling the samples leaves of the squared error

    // How many samples it takes to come down to a smaller error, from so many.
    double samplesFor(double target, int samples) const;
};

// Fewer samples tell nothing.
inline constexpr int leastSamplesForNoise = 4;

// pixels: how many the sums are over.
NoiseEstimate estimateNoise(const NoiseSums& sums, int samples, double pixels);

// An error as exactly as it is known, e.g. 0.056.
std::string noiseText(double error);

}  // namespace render
