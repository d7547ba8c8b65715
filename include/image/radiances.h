// A picture as light: what each pixel shows, linear.
#pragma once

#include "core/vec.h"
#include "image/image.h"

namespace image {

// How a picture's numbers stand for light.
enum class NumberCurve {
    asFile,  // floats in proportion; whole numbers as the file says, by a power or the curve of sRGB
    srgb,  // all by that curve
    none  // all in proportion
};

// A channel's numbers as floats; whole ones begin as 0 to 1.
std::vector<float> linearNumbers(const Image& image, const ImageChannel& channel, NumberCurve curve);

// Linear red, green and blue of each pixel, line after line from the top; grey counts for all three channels, alpha for
// nothing. Throws core::Error, naming the file and the first pixel, for numbers that are not finite, negative or
// greater than `most`, and for a picture without colours. what: light or colours, as the message calls it.
std::vector<core::Rgbf> linearColours(const Image& image, const std::string& path, NumberCurve curve, float most,
                                      std::string_view what = "colours");

// The radiance of each pixel: its colour as the file says. What is transparent shows black behind it. Throws
// core::Error as above, and for a picture that is black all over or a part of a larger one.
std::vector<core::Rgbf> radiancesOf(const Image& image, const std::string& path, float most);

}  // namespace image
