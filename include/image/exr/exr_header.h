// What an OpenEXR file says of itself, and whether such a file is read.
#pragma once

#include "image/image.h"

#include <ImfHeader.h>
#include <ImfMultiPartInputFile.h>

#include <string_view>

namespace image::exr {

// The number of the first part with colours or grey, or else of the first one with a number for each pixel. Throws
// core::Error where all are deep.
int partToRead(const Imf::MultiPartInputFile& file);

// Whether its colours are kept as luminance Y and, for every other pixel of every other line, chroma RY and BY.
bool hasLuminanceAndChroma(const Imf::ChannelList& channels);
inline bool isColour(std::string_view name) {
    return name == "R" || name == "G" || name == "B";
}

// The picture without its numbers. order: of its attributes. Throws core::Error for what is not read.
Image imageOf(const Imf::Header& header, const std::vector<std::string>& order);

// Throws core::Error for a part that has not been written to its end, or is larger than so many bytes can hold.
void checkSize(const Imf::Header& header, bool isComplete, std::uint64_t bytes);

// What the library says, as the end of a sentence.
std::string printable(std::string_view message);

}  // namespace image::exr
