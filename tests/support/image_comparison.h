// Whether a rendered image agrees with a reference.
#pragma once

#include <span>

#include "support/statistics.h"

namespace support {

struct ImageComparison {
    TestResult pixels;  // of the pixel that differs most
    TestResult mean;  // of the whole image
    bool accepted = false;
    std::string text;
};

// One value a pixel: a channel, or the luminance. Channels share their samples, so they must be compared one by one.
// varianceOfMean: the variance of a pixel's samples divided by their number, plus the reference's if that has noise.
// Every pixel must agree, and the mean of the image too: an error far below the noise of a pixel shows only there.
// A pixel needs enough samples to be nearly normal; a hundred or more where the light is not too uneven.
ImageComparison compareImages(std::span<const double> mean, std::span<const double> varianceOfMean,
                              std::span<const double> reference, double level = significance());

}  // namespace support
