#include "image/radiances.h"

#include "core/error.h"
#include "core/option.h"
#include "core/srgb.h"

#include <algorithm>
#include <cmath>

namespace image {
namespace {

[[noreturn]] void fail(std::string_view what, const std::string& path, const std::string& why) {
    throw core::Error("PICTURE", "COLOURS", path,
                      "cannot take " + std::string(what) + " from \"" + path + "\": " + why);
}

// A PNG does not tell its whole size where it says where it belongs; those of gr_render do so by a text.
bool isOnlyPart(const Image& image) {
    if (!image.isPart) return false;
    const auto says = [&](const char* key, int number) {
        return std::ranges::any_of(image.metadata, [&](const auto& text) {
            return text.first == key && text.second != std::to_string(number);
        });
    };
    return image.held != image.whole || says("grsh:width", image.held.width) || says("grsh:height", image.held.height);
}

// What is wrong with a number, or nothing.
std::string faultOf(float x, float most) {
    if (!std::isfinite(x)) return "is not finite";
    if (x < 0) return "is negative";
    return x > most ? "is greater than " + core::numberText(most) : "";
}

}  // namespace

std::vector<float> linearNumbers(const Image& image, const ImageChannel& channel, NumberCurve curve) {
    const auto linear = [&](double x) {
        if (curve == NumberCurve::none) return x;
        const bool isSrgb = curve == NumberCurve::srgb || image.gamma == 0;
        return isSrgb ? core::decodeSrgb(x) : std::pow(x, 1 / image.gamma);
    };
    const auto convert = [&]<class Number>(const std::vector<Number>& numbers) {
        std::vector<float> floats(numbers.size());
        if constexpr (std::is_same_v<Number, float>) {
            const bool isSrgb = curve == NumberCurve::srgb;
            std::transform(numbers.begin(), numbers.end(), floats.begin(), [&](float x) {
                return isSrgb && x > 0 ? static_cast<float>(core::decodeSrgb(static_cast<double>(x))) : x;
            });
        } else {
            constexpr int most = std::numeric_limits<Number>::max();
            std::vector<float> table(most + 1);
            for (int i = 0; i <= most; ++i)
                table[static_cast<std::size_t>(i)] = static_cast<float>(linear(i / double(most)));
            std::transform(numbers.begin(), numbers.end(), floats.begin(), [&](Number i) { return table[i]; });
        }
        return floats;
    };
    return std::visit(convert, channel.samples);
}

std::vector<core::Rgbf> linearColours(const Image& image, const std::string& path, NumberCurve curve, float most,
                                      std::string_view what) {
    const bool isGrey = image.find("R") == nullptr && image.find("Y") != nullptr;
    std::vector<core::Rgbf> colours(image.pixels());
    for (int c = 0; c < 3; ++c) {
        const ImageChannel* channel = image.find(isGrey ? "Y" : std::string(1, "RGB"[c]));
        if (channel == nullptr) fail(what, path, "it has the channels " + image.channelNames() + ", not R, G and B");
        const std::vector<float> numbers = linearNumbers(image, *channel, curve);
        for (std::size_t i = 0; i < numbers.size(); ++i) colours[i][c] = numbers[i];
    }
    const auto width = static_cast<std::size_t>(image.held.width);
    for (std::size_t i = 0; i < colours.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (const std::string fault = faultOf(colours[i][c], most); !fault.empty())
                fail(what, path,
                     "its pixel " + std::to_string(i % width) + " " + std::to_string(i / width) + " " + fault);
    return colours;
}

std::vector<core::Rgbf> radiancesOf(const Image& image, const std::string& path, float most) {
    constexpr std::string_view what = "light";
    if (isOnlyPart(image)) fail(what, path, "it holds only a part of its picture");
    std::vector<core::Rgbf> radiances = linearColours(image, path, NumberCurve::asFile, most, what);
    // A PNG's colours are those of the pixel where it is covered; an OpenEXR file's already are what shows.
    const ImageChannel* alpha = image.find("A");
    if (alpha != nullptr && !std::holds_alternative<std::vector<float>>(alpha->samples)) {
        const std::vector<float> coverage = linearNumbers(image, *alpha, NumberCurve::none);
        for (std::size_t i = 0; i < coverage.size(); ++i) radiances[i] *= coverage[i];
    }
    if (std::ranges::all_of(radiances, [](const core::Rgbf& c) { return c == core::Rgbf(0); }))
        fail(what, path, "it is black all over");
    return radiances;
}

}  // namespace image
