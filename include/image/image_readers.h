// What reads the formats of picture files; image_writers.h writes them.
#pragma once

#include "image/image.h"

#include <cstdio>

namespace image {

// Each reads a file that is open at its start. Throws core::Error, whose message tells why, for what is not all of a
// file of its format, for what would not fit into memory, and for colours other than those of sRGB.

// PNG of any kind. Palettes become colours, grey of fewer than 8 bits becomes 8, a transparent colour a channel A.
Image readPng(std::FILE* file);

// OpenEXR: the first part that holds a picture, of lines or tiles, in any compression; half floats become floats, and
// luminance and chroma become colours. A program of its own reads it, grsh_exr, which stands beside this one.
Image readExr(std::FILE* file);

// Radiance's pictures, with runs of pixels, of bytes or without, from whatever corner. What EXPOSURE and COLORCORR say
// that the numbers were multiplied by is taken back. It is not written.
Image readHdr(std::FILE* file);

// Portable float map, of three colours or of grey, of either byte order. Its scale is a factor.
Image readPfm(std::FILE* file);

}  // namespace image
