// Lines of pixels as most files pack them, by deflate or not at all. OpenEXR's library takes every number of those
// apart byte by byte, which is half of the time that it needs; here they are copied.
#pragma once

#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfPixelType.h>

#include <span>
#include <vector>

namespace image::exr {

// Whether a part's lines can be read here: floats and half floats, one for each pixel.
bool canReadLines(const Imf::Header& header);

class LineReader {
public:
    explicit LineReader(Imf::InputPart& part);

    // The part's lines from the first to the last one, of which the first begins what the file packs together: for each
    // channel a number for each pixel. Throws core::Error, or what the library throws.
    void read(int first, int last, std::vector<std::vector<float>>& channels);

private:
    std::span<const char> unpack(std::span<const char> packed, std::size_t size);

    Imf::InputPart& part_;
    std::size_t width_, bytesPerLine_ = 0;
    std::vector<Imf::PixelType> types_;
    std::vector<char> inflated_, ordered_;
};

}  // namespace image::exr
