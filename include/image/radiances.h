// A picture as light: what each pixel shows, linear.
#pragma once

#include "core/vec.h"
#include "image/image.h"

namespace image {

// A channel's numbers as floats: those of a file of floats as they are, whole ones back from 0 to 1 by the curve that
// the picture tells, sRGB's or a power; isCovering: but not those of alpha, which have gone through none.
std::vector<float> linearNumbers(const Image& image, const ImageChannel& channel, bool isCovering = false);

// The radiance of each pixel, line after line from the top; grey counts for all three channels. What is transparent
// shows black behind it. Throws core::Error, naming the file and the first pixel, for numbers that are not finite,
// negative or greater than `most`, for a picture that is black all over or has no colours, and for one that is a part
// of a larger one.
std::vector<core::Rgbf> radiancesOf(const Image& image, const std::string& path, float most);

}  // namespace image
