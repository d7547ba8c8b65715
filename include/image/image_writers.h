// The formats of picture files. To add one: its functions here and in image_readers.h, in files of their own, and its
// row in src/image/image_file.cpp.
#pragma once

#include "image/image_file.h"

#include <cstdio>

namespace image {

// Each writes a film, or a picture that was read from a file of its format, into a file that is open for writing, from
// its start. A whole picture put together from its parts makes the bytes that its film made. Throws core::Error, whose
// message tells why, where that fails.

// 8 bits a channel: radiance * 2^exposure through the curve. A part's place is in the PNG's offset.
void writePng(std::FILE* file, const Film& film, const ViewTransform& view, const Metadata& metadata);
void writePng(std::FILE* file, const Image& image);

// OpenEXR: floats, radiance and layers, the metadata as attributes. A part is a data window within the whole picture,
// the display window. How it is to be viewed changes nothing.
void writeExr(std::FILE* file, const Film& film, const ViewTransform& view, const Metadata& metadata);
void writeExr(std::FILE* file, const Image& image);

// Portable float map: radiance as floats, and nothing else. A part is a picture of its own.
void writePfm(std::FILE* file, const Film& film, const ViewTransform& view, const Metadata& metadata);
void writePfm(std::FILE* file, const Image& image);

}  // namespace image
