// What a PNG says of its colours.
#pragma once

#include <png.h>

namespace image {

// To be called before the header is read: the chunk cICP, which older libraries do not know, is kept as it is.
void keepColourChunks(png_structp png);

// Once the header is read: what light was raised to, as Image::gamma. Throws core::Error for other colours than those
// of sRGB. What says nothing of its colours is taken for sRGB, as by everybody. Where there are several, cICP goes
// before sRGB, that before iCCP, and that before cHRM and gAMA.
double gammaOf(png_structp png, png_infop info);

}  // namespace image
