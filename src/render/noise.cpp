#include "render/noise.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace render {
namespace {

// Of each pixel of a rectangle, the mean of the squares of those round it; its own square where there are no others.
std::vector<glm::dvec3> squaresAround(std::span<const core::Rgbf> means, int width) {
    const std::size_t columns = static_cast<std::size_t>(width), rows = means.size() / columns;
    std::vector<glm::dvec3> around;
    around.reserve(means.size());
    // Of each column the squares above and below, and these with the one between; a column of nothing at either end.
    std::vector<glm::dvec3> two(columns + 2, glm::dvec3(0)), three(columns + 2, glm::dvec3(0));
    const auto square = [&](std::size_t row, std::size_t column) {
        const glm::dvec3 mean(means[row * columns + column]);
        return mean * mean;
    };
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            glm::dvec3 sum(0);
            if (row > 0) sum += square(row - 1, column);
            if (row + 1 < rows) sum += square(row + 1, column);
            two[column + 1] = sum;
            three[column + 1] = sum + square(row, column);
        }
        const int high = 1 + (row > 0) + (row + 1 < rows);
        for (std::size_t column = 0; column < columns; ++column) {
            const int others = high * (1 + (column > 0) + (column + 1 < columns)) - 1;
            around.push_back(others == 0
                                 ? square(row, column)
                                 : (three[column] + two[column + 1] + three[column + 2]) / static_cast<double>(others));
        }
    }
    return around;
}

// What a step leaves of the squared error. Independent samples leave half; those that are spread evenly less, down to
// an eighth and beyond for what is smooth, but light that is found by chance soon outweighs that. So much is known
// before anything is measured; the last two steps tell the more, the less they owe to a few pixels.
double ratioOf(const NoiseStep& before, const NoiseStep& last) {
    constexpr double least = 0.2, most = 0.5;
    constexpr double expected = most, deviation = 0.3;  // of its logarithm
    if (before.moved == 0 || last.moved == 0) return expected;
    const auto relativeVariance = [](const NoiseStep& step) { return step.squares / (step.moved * step.moved); };
    const double variance = relativeVariance(before) + relativeVariance(last);
    const double trust = deviation * deviation / (deviation * deviation + variance);
    return std::clamp(expected * std::pow(last.moved / before.moved / expected, trust), least, most);
}

// Squared errors relative to that of the power of two at or below a number of samples, `ratio` being left by each
// doubling.
struct Beyond {
    double left;  // that of all samples
    double moved;  // how far the samples beyond move the mean

    // The samples are blocks, each a power of two and at most half as large as the one before. Those behind a block lie
    // in its twin. The two together have `ratio` of the squared error of one, so they go against each other by 2 ratio
    // - 1, and so does each part of the twin.
    Beyond(int samples, double ratio) {
        const double against = 2 * ratio - 1;
        const unsigned all = static_cast<unsigned>(samples), power = std::bit_floor(all);
        double sum = 0;
        double squared = 1;  // error of a block
        for (unsigned block = power; block > 0; block /= 2, squared /= ratio)
            if ((all & block) != 0) sum += block * squared * (block + 2 * against * (all & (block - 1)));
        left = sum / all / all;
        moved = 1 + left - 2 * (power + against * (all - power)) / all;
    }
};

}  // namespace

NoiseStep noiseStep(std::span<const core::Rgbf> before, std::span<const core::Rgbf> after, int width) {
    constexpr double dark = 0.01;  // squared radiance: where a pixel is darker, its error is not relative to it
    const std::vector<glm::dvec3> around = squaresAround(after, width);
    NoiseStep step;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const glm::dvec3 mean(after[i]);
        const glm::dvec3 moved = mean - glm::dvec3(before[i]);
        // A pixel that is bright by one rare sample is no bright pixel: it is measured against those round it.
        const glm::dvec3 square = glm::min(mean * mean, around[i]);
        const double part = glm::dot(moved * moved / (square + dark), glm::dvec3(1));
        step.moved += part;
        step.squares += part * part;
    }
    return step;
}

double NoiseEstimate::samplesFor(double target, int samples) const {
    return samples * std::pow(error / target, -2 / std::log2(ratio));
}

std::optional<NoiseEstimate> estimateNoise(std::span<const NoiseStep> steps, const std::optional<NoiseStep>& rest,
                                           int samples, double pixels) {
    if (samples < 4) return std::nullopt;
    const unsigned power = std::bit_floor(static_cast<unsigned>(samples));
    const std::size_t last = static_cast<std::size_t>(std::bit_width(power)) - 2;
    const double ratio = ratioOf(steps[last - 1], steps[last]);
    const Beyond beyond(samples, ratio);
    // The steps to come would move the means by `ratio` less each time, until nothing is left.
    double squared = steps[last].moved * ratio / (1 - ratio) * beyond.left;
    // The nearer the next power of two is, the more the way there tells.
    if (rest && beyond.moved > 0)
        squared += (static_cast<double>(samples) / power - 1) * (rest->moved / beyond.moved * beyond.left - squared);
    return NoiseEstimate{std::sqrt(squared / (3 * pixels)), ratio};
}

}  // namespace render
