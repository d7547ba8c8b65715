// The median filter as one would write it down: gather the window, find its middle.
#pragma once

#include <algorithm>
#include <vector>

namespace image {

template<class Number>
Number plainMedian(const std::vector<Number>& numbers, int width, int height, int x, int y, int n) {
    static thread_local std::vector<Number> window;
    window.clear();
    const int reach = n / 2;
    for (int row = std::max(0, y - reach); row <= std::min(height - 1, y + reach); ++row)
        for (int column = std::max(0, x - reach); column <= std::min(width - 1, x + reach); ++column)
            window.push_back(numbers[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(column)]);
    const auto middle = window.begin() + static_cast<std::ptrdiff_t>(window.size() / 2);
    std::nth_element(window.begin(), middle, window.end());
    if (window.size() % 2 == 1) return *middle;
    const Number below = *std::max_element(window.begin(), middle);
    if constexpr (std::is_same_v<Number, float>)
        return static_cast<float>((static_cast<double>(below) + static_cast<double>(*middle)) / 2);
    else
        return static_cast<Number>((below + *middle + 1) / 2);
}

template<class Number>
std::vector<Number> plainMedianFilter(const std::vector<Number>& numbers, int width, int height, int n) {
    std::vector<Number> medians;
    medians.reserve(numbers.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) medians.push_back(plainMedian(numbers, width, height, x, y, n));
    return medians;
}

}  // namespace image
