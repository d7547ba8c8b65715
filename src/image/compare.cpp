#include "image/compare.h"

#include "core/error.h"
#include "image/image_file.h"
#include "image/radiances.h"

#include <algorithm>
#include <cmath>

namespace image {
namespace {

constexpr std::array<core::Word, 4> metrics{"mse", "relmse", "psnr", "flip"};

const std::array<core::OptionRow<CompareSettings>, 3> rows{{
    {.name = "metric",
     .member = &CompareSettings::metric,
     .words = metrics,
     .help = "the figure that counts: mean squared error, the same relative to b, peak signal to noise ratio, or FLIP"},
    {.name = "tolerance",
     .member = &CompareSettings::tolerance,
     .range = core::notNegative,
     .defaultText = "none",
     .help = "the most that the figure may be, or the least of psnr; beyond it the command fails"},
    {.name = "difference",
     .member = &CompareSettings::difference,
     .defaultText = "none",
     .help = "a picture to be written of where they differ: |a-b| of each channel, or FLIP's own, grey"},
}};

[[noreturn]] void fail(const std::string& path, const std::string& why) {
    throw core::Error("COMPARE", "PICTURE", path, "cannot compare \"" + path + "\": " + why);
}

void checkFinite(const Image& image, const std::vector<float>& numbers, const std::string& path) {
    const auto bad = std::ranges::find_if(numbers, [](float x) { return !std::isfinite(x); });
    if (bad == numbers.end()) return;
    const std::size_t i = static_cast<std::size_t>(bad - numbers.begin()),
                      width = static_cast<std::size_t>(image.held.width);
    fail(path, "its pixel " + std::to_string(i % width) + " " + std::to_string(i / width) + " is not finite");
}

// Empty where all pixels are covered wholly.
std::vector<float> coverageOf(const Image& image, const std::string& path) {
    const ImageChannel* alpha = image.find("A");
    if (alpha == nullptr) return {};
    std::vector<float> coverage = linearNumbers(image, *alpha, NumberCurve::none);
    checkFinite(image, coverage, path);
    return std::ranges::all_of(coverage, [](float x) { return x == 1; }) ? std::vector<float>() : coverage;
}

// Its own file says so; no reader takes that curve back. Floats have gone through none.
bool isFilmic(const Image& image) {
    const bool says =
        std::ranges::count(image.metadata, std::pair<std::string, std::string>("grsh:curve", "filmic")) > 0;
    return says && !std::holds_alternative<std::vector<float>>(image.channels[0].samples);
}

double squared(double x) {
    return x * x;
}

double encoded(float radiance) {
    return encodeSrgb(std::clamp(static_cast<double>(radiance), 0., 1.));
}

}  // namespace

std::span<const core::OptionRow<CompareSettings>> CompareSettings::options() {
    return rows;
}

Colours coloursOf(const Image& image, const std::string& path) {
    const bool isGrey = image.find("R") == nullptr && image.find("Y") != nullptr;
    Colours colours{image.held.width, image.held.height, std::vector<core::Rgbf>(image.pixels()),
                    coverageOf(image, path), isFilmic(image)};
    for (int c = 0; c < 3; ++c) {
        const ImageChannel* channel = image.find(isGrey ? "Y" : std::string(1, "RGB"[c]));
        if (channel == nullptr) fail(path, "it has the channels " + image.channelNames() + ", not R, G and B");
        const std::vector<float> numbers = linearNumbers(image, *channel, NumberCurve::asFile);
        checkFinite(image, numbers, path);
        // A PNG's colours are those of the pixel where it is covered; an OpenEXR file's already are what shows.
        const bool isWhatShows = std::holds_alternative<std::vector<float>>(channel->samples);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            colours.pixels[i][c] = isWhatShows ? numbers[i] : numbers[i] * colours.coverageAt(i);
    }
    return colours;
}

Comparison compare(const Colours& a, const Colours& b) {
    Comparison result;
    double shownError = 0;
    const auto add = [&](double x, double reference, std::size_t i) {
        const double difference = std::abs(x - reference);
        result.mse += squared(difference);
        result.relmse += squared(difference) / (squared(reference) + 0.01);
        if (difference <= result.largest) return difference;
        result.largest = difference;
        result.x = static_cast<int>(i % static_cast<std::size_t>(a.width));
        result.y = static_cast<int>(i / static_cast<std::size_t>(a.width));
        return difference;
    };
    const bool hasCoverage = !a.coverage.empty() || !b.coverage.empty();
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const float x = a.pixels[i][c], reference = b.pixels[i][c];
            if (add(x, reference, i) != 0) shownError += squared(encoded(x) - encoded(reference));
        }
        if (hasCoverage) shownError += squared(add(a.coverageAt(i), b.coverageAt(i), i));
    }
    const double count = (hasCoverage ? 4 : 3) * static_cast<double>(a.pixels.size());
    result.mse /= count;
    result.relmse /= count;
    result.psnr = -10 * std::log10(shownError / count);
    return result;
}

std::vector<core::Rgbf> shown(const Colours& colours) {
    std::vector<core::Rgbf> pixels = colours.pixels;
    for (core::Rgbf& pixel : pixels) pixel = glm::clamp(pixel, 0.f, 1.f);
    return pixels;
}

}  // namespace image
