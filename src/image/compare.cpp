#include "image/compare.h"

#include "core/error.h"
#include "image/image_file.h"

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

// A channel's numbers as floats; those of a PNG from 0 to 1, through the curve given.
std::vector<float> floatsOf(const ImageChannel& channel, double (*curve)(double)) {
    const auto convert = [&]<class Number>(const std::vector<Number>& numbers) {
        if constexpr (std::is_same_v<Number, float>) {
            return numbers;
        } else {
            constexpr int most = std::numeric_limits<Number>::max();
            std::vector<float> table(most + 1), floats(numbers.size());
            for (int i = 0; i <= most; ++i)
                table[static_cast<std::size_t>(i)] = static_cast<float>(curve(i / double(most)));
            std::transform(numbers.begin(), numbers.end(), floats.begin(), [&](Number i) { return table[i]; });
            return floats;
        }
    };
    return std::visit(convert, channel.samples);
}

void checkOpaque(const Image& image, const std::string& path) {
    const ImageChannel* alpha = image.find("A");
    if (alpha == nullptr) return;
    for (const float coverage : floatsOf(*alpha, [](double x) { return x; }))
        if (coverage != 1) fail(path, "it is transparent in places");
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
    checkOpaque(image, path);
    const bool isGrey = image.find("R") == nullptr && image.find("Y") != nullptr;
    Colours colours{image.held.width, image.held.height, std::vector<core::Rgbf>(image.pixels())};
    for (int c = 0; c < 3; ++c) {
        const ImageChannel* channel = image.find(isGrey ? "Y" : std::string(1, "RGB"[c]));
        if (channel == nullptr) fail(path, "it has the channels " + image.channelNames() + ", not R, G and B");
        const std::vector<float> numbers = floatsOf(*channel, decodeSrgb);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (!std::isfinite(numbers[i])) {
                const std::size_t width = static_cast<std::size_t>(image.held.width);
                fail(path,
                     "its pixel " + std::to_string(i % width) + " " + std::to_string(i / width) + " is not finite");
            }
            colours.pixels[i][c] = numbers[i];
        }
    }
    return colours;
}

Comparison compare(const Colours& a, const Colours& b) {
    Comparison result;
    double shownError = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double reference = b.pixels[i][c], difference = std::abs(a.pixels[i][c] - reference);
            result.mse += squared(difference);
            result.relmse += squared(difference) / (squared(reference) + 0.01);
            if (difference != 0) shownError += squared(encoded(a.pixels[i][c]) - encoded(b.pixels[i][c]));
            if (difference <= result.largest) continue;
            result.largest = difference;
            result.x = static_cast<int>(i % static_cast<std::size_t>(a.width));
            result.y = static_cast<int>(i / static_cast<std::size_t>(a.width));
        }
    }
    const double count = 3 * static_cast<double>(a.pixels.size());
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
