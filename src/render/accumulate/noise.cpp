#include "render/accumulate/noise.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>

namespace render {
namespace {

// The mean square of the pixels at most four away in the line; a pixel's own where there are no others. Lines above and
// below have no say: they may be another strip's.
glm::dvec3 squareAround(std::span<const core::Rgbf> means, std::size_t pixel) {
    constexpr std::size_t reach = 4;
    const std::size_t first = pixel - std::min(pixel, reach), last = std::min(pixel + reach, means.size() - 1);
    glm::dvec3 sum(0);
    for (std::size_t i = first; i <= last; ++i)
        if (i != pixel || first == last) sum += glm::dvec3(means[i]) * glm::dvec3(means[i]);
    return sum / static_cast<double>(std::max<std::size_t>(last - first, 1));
}

// What a step leaves of the squared error. Independent samples leave half; those that are spread evenly less, down to
// an eighth and beyond for what is smooth, but light that is found by chance soon outweighs that. So much is known
// before anything is measured; the last two steps tell the more, the less they owe to a few pixels.
double ratioOf(const NoiseStep& before, const NoiseStep& last) {
    constexpr double least = 0.2, most = 0.5;
    constexpr double expected = most, deviation = 0.3;  // of its logarithm
    const double movedBefore = before.moved.value(), movedLast = last.moved.value();
    if (movedBefore == 0 || movedLast == 0) return expected;
    const auto relativeVariance = [](const NoiseStep& step) {
        return step.squares.value() / std::pow(step.moved.value(), 2);
    };
    const double variance = relativeVariance(before) + relativeVariance(last);
    const double trust = deviation * deviation / (deviation * deviation + variance);
    return std::clamp(expected * std::pow(movedLast / movedBefore / expected, trust), least, most);
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

void NoiseStep::add(std::span<const core::Rgbf> before, std::span<const core::Rgbf> after, double allOverNew) {
    constexpr double dark = 0.01;  // squared radiance: where a pixel is darker, its error is not relative to it
    double lineMoved = 0, lineSquares = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const glm::dvec3 mean(after[i]);
        const glm::dvec3 way = mean - glm::dvec3(before[i]);
        // A pixel that is bright by one rare sample is no bright pixel: it is measured against those beside it, or what
        // its first and its new samples both have found, if that is brighter.
        const glm::dvec3 first(before[i]), added = first + way * allOverNew;
        const glm::dvec3 both = glm::max(glm::min(first, added), glm::dvec3(0));
        const glm::dvec3 square = glm::max(both * both, glm::min(mean * mean, squareAround(after, i)));
        const double part = glm::dot(way * way / (square + dark), glm::dvec3(1));
        lineMoved += part;
        lineSquares += part * part;
    }
    moved.add(lineMoved);
    squares.add(lineSquares);
}

NoiseStep& NoiseSteps::to(int samples) {
    const unsigned all = static_cast<unsigned>(samples);
    if (!std::has_single_bit(all)) return rest;
    const std::size_t doubling = static_cast<std::size_t>(std::bit_width(all)) - 2;
    doublings.resize(std::max(doublings.size(), doubling + 1));
    return doublings[doubling];
}

NoiseSteps& NoiseSteps::operator+=(const NoiseSteps& other) {
    doublings.resize(std::max(doublings.size(), other.doublings.size()));
    for (std::size_t i = 0; i < other.doublings.size(); ++i) doublings[i] += other.doublings[i];
    rest += other.rest;
    return *this;
}

NoiseSums::NoiseSums(const NoiseSteps& steps, int samples, bool isWhole) {
    const std::size_t doubled = static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(samples))) - 1;
    before = steps.doublings[doubled - 2];
    last = steps.doublings[doubled - 1];
    if (isWhole) rest = steps.rest.moved;
}

NoiseSums& NoiseSums::operator+=(const NoiseSums& other) {
    before += other.before;
    last += other.last;
    if (rest && other.rest)
        *rest += *other.rest;
    else
        rest.reset();
    return *this;
}

std::string NoiseSums::text() const {
    std::string text =
        before.moved.text() + " " + before.squares.text() + " " + last.moved.text() + " " + last.squares.text();
    if (rest) text += " " + rest->text();
    return text;
}

std::optional<NoiseSums> NoiseSums::fromText(std::string_view text) {
    std::vector<core::AnyOrderSum> sums;
    while (true) {
        const std::size_t space = text.find(' ');
        const auto sum = core::AnyOrderSum::fromText(text.substr(0, space));
        if (!sum) return std::nullopt;
        sums.push_back(*sum);
        if (space == std::string_view::npos) break;
        text.remove_prefix(space + 1);
    }
    if (sums.size() != 4 && sums.size() != 5) return std::nullopt;
    NoiseSums read;
    read.before = {sums[0], sums[1]};
    read.last = {sums[2], sums[3]};
    if (sums.size() == 5) read.rest = sums[4];
    return read;
}

double NoiseEstimate::samplesFor(double target, int samples) const {
    return samples * std::pow(error / target, -2 / std::log2(ratio));
}

NoiseEstimate estimateNoise(const NoiseSums& sums, int samples, double pixels) {
    const double ratio = ratioOf(sums.before, sums.last);
    const Beyond beyond(samples, ratio);
    // The steps to come would move the means by `ratio` less each time, until nothing is left.
    double squared = sums.last.moved.value() * ratio / (1 - ratio) * beyond.left;
    // The nearer the next power of two is, the more the way there tells.
    if (sums.rest && beyond.moved > 0) {
        const double way = static_cast<double>(samples) / std::bit_floor(static_cast<unsigned>(samples)) - 1;
        squared += way * (sums.rest->value() / beyond.moved * beyond.left - squared);
    }
    return {std::sqrt(squared / (3 * pixels)), ratio};
}

std::string noiseText(double error) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", error);
    return text;
}

}  // namespace render
