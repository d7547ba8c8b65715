// What fuzzers of picture files share.
#pragma once

#include "core/error.h"
#include "image/image.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>

namespace fuzz {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A file of these bytes, which is read from its start.
inline File fileOf(const std::uint8_t* bytes, std::size_t size) {
    return File(fmemopen(const_cast<std::uint8_t*>(bytes), size, "rb"), std::fclose);
}

// A picture that was read must be whole: each channel has a number for each pixel.
inline void checkPicture(const image::Image& image) {
    if (image.channels.empty() || image.pixels() == 0) std::abort();
    for (const image::ImageChannel& channel : image.channels)
        if (std::visit([](const auto& numbers) { return numbers.size(); }, channel.samples) != image.pixels())
            std::abort();
}

// Reads it; errors that are told are right, whatever is read.
template<class Read>
void readPicture(const std::uint8_t* bytes, std::size_t size, const Read& read) {
    if (size == 0) return;
    try {
        checkPicture(read(fileOf(bytes, size).get()));
    } catch (const core::Error&) {
    }
}

}  // namespace fuzz
