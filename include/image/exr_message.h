// What grsh_exr writes (core/reader_process.h): this; the name of each channel; name and value of each text; and then
// part by part some lines of each channel, as floats. A text is its length, four bytes, and its letters.
#pragma once

#include "image/image.h"

#include <cstdint>

namespace image {

struct ExrMessage {
    Window held, whole;
    std::int32_t partsLeftOut = 0;
    std::int32_t linesAtOnce = 0;
    std::uint32_t channels = 0, texts = 0;
};

}  // namespace image
