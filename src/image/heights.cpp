#include "image/heights.h"

#include "core/error.h"

#include <cmath>

namespace image {
namespace {

void add(const ImageChannel& channel, double weight, std::vector<double>& heights) {
    const auto addNumbers = [&]<class Number>(const std::vector<Number>& numbers) {
        const double most = std::is_same_v<Number, float> ? 1 : static_cast<double>(std::numeric_limits<Number>::max());
        for (std::size_t i = 0; i < numbers.size(); ++i)
            heights[i] += weight * (static_cast<double>(numbers[i]) / most);
    };
    std::visit(addNumbers, channel.samples);
}

}  // namespace

std::vector<double> heightsOf(const Image& image, const std::string& path) {
    const auto fail = [&](const std::string& why) {
        throw core::Error("HEIGHTS", "PICTURE", path, "cannot take heights from \"" + path + "\": " + why);
    };
    std::vector<double> heights(image.pixels());
    const ImageChannel* grey = image.find("Y");
    if (grey != nullptr && image.find("R") == nullptr) {
        add(*grey, 1, heights);
    } else {
        constexpr std::pair<const char*, double> weights[] = {{"R", 0.2126}, {"G", 0.7152}, {"B", 0.0722}};
        for (const auto& [name, weight] : weights) {
            const ImageChannel* channel = image.find(name);
            if (channel == nullptr) fail("it has the channels " + image.channelNames() + ", not R, G and B");
            add(*channel, weight, heights);
        }
    }
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const std::size_t width = static_cast<std::size_t>(image.held.width);
        if (!std::isfinite(heights[i]))
            fail("its pixel " + std::to_string(i % width) + " " + std::to_string(i / width) + " is not finite");
    }
    return heights;
}

}  // namespace image
