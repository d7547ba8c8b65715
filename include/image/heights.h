// A picture whose brightness tells heights.
#pragma once

#include "image/image.h"

namespace image {

// The luminance of each pixel, line after line from the top: 0.2126 R + 0.7152 G + 0.0722 B, or Y of a grey picture, of
// the numbers as the file has them, whole ones divided by the largest. No curve is taken from them, since whoever draws
// heights means numbers; alpha counts nothing. Throws core::Error, naming the file, for a picture without colours and
// for numbers that are not finite.
std::vector<double> heightsOf(const Image& image, const std::string& path);

}  // namespace image
