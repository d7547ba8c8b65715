#include "support/image_comparison.h"

#include <cmath>
#include <stdexcept>

namespace support {

ImageComparison compareImages(std::span<const double> mean, std::span<const double> varianceOfMean,
                              std::span<const double> reference, double level) {
    const std::size_t count = mean.size();
    if (count == 0 || varianceOfMean.size() != count || reference.size() != count)
        throw std::invalid_argument("compareImages: as many means, variances and references, and at least one");

    // Find the pixel that differs most, and the mean of the image.
    std::size_t worst = 0;
    double worstScore = -1;
    double sum = 0, sumOfVariances = 0, referenceSum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double score = std::abs(zScore(mean[i], std::sqrt(varianceOfMean[i]), reference[i]));
        if (score > worstScore) {
            worst = i;
            worstScore = score;
        }
        sum += mean[i];
        sumOfVariances += varianceOfMean[i];
        referenceSum += reference[i];
    }

    // Both tests together are one test of the level asked for.
    const double half = sidak(level, 2);
    const auto n = static_cast<double>(count);
    ImageComparison result;
    result.pixels = zTest(mean[worst], std::sqrt(varianceOfMean[worst]), reference[worst], sidak(half, n));
    result.mean = zTest(sum / n, std::sqrt(sumOfVariances) / n, referenceSum / n, half);
    result.accepted = result.pixels.accepted && result.mean.accepted;
    result.text = "worst pixel, number " + std::to_string(worst) + ": " + result.pixels.text +
                  "; whole image: " + result.mean.text;
    return result;
}

}  // namespace support
