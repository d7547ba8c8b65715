// The report's median filter (section 5.4): takes noise out of a picture that has had too few samples.
#pragma once

#include "image/image.h"

#include <span>
#include <vector>

namespace image {

inline constexpr int largestMedian = 15;

// Each number becomes the median of those in the n x n window round its place, of which the edges of the picture may
// cut off a part; of an even count, the mean of the two in the middle, for whole numbers rounded up. n: odd, from 1 to
// largestMedian. threads: 0 is all cores.
template<class Number>
std::vector<Number> medianFilter(std::span<const Number> numbers, int width, int height, int n, int threads = 0);

// Filters each channel by itself. NaN counts as greater than any number.
void applyMedian(Image& image, int n);

}  // namespace image
