// Pictures to be written and read, made from numbers of a test's own.
#pragma once

#include "image/image.h"
#include "image/layer.h"
#include "support/test_random.h"

#include <array>

namespace image {

inline constexpr std::array<Layer, layerCount> everyLayer{Layer::albedo, Layer::normal, Layer::depth, Layer::variance,
                                                          Layer::samples};

// Whole numbers of all their bits; floats from -1 to 1.
template<class Number>
std::vector<Number> randomNumbers(std::size_t count, std::uint64_t seed) {
    support::TestRandom random(seed);
    std::vector<Number> numbers(count);
    for (Number& number : numbers) {
        if constexpr (std::is_same_v<Number, float>)
            number = static_cast<float>(2 * random.next() - 1);
        else
            number = static_cast<Number>(random.nextBits());
    }
    return numbers;
}

// channels: a letter for each.
template<class Number>
Image randomImage(int width, int height, std::string_view channels, std::uint64_t seed = 1) {
    Image image;
    image.held = image.whole = {0, 0, width, height};
    for (const char name : channels)
        image.channels.push_back({std::string(1, name), randomNumbers<Number>(image.pixels(), seed++)});
    return image;
}

}  // namespace image
