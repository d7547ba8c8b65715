// What a file says of its own size, looked at before memory is reserved for it.
#pragma once

#include "core/error.h"

#include <cstdint>
#include <cstdio>
#include <string>

namespace image {

// The reason why a file is not read.
[[noreturn]] inline void failReading(const std::string& why) {
    throw core::Error("FILE", "READ", "", why);
}

// Of a file that is open; where it is read from stays. 0 where it cannot be told.
inline std::uint64_t sizeOf(std::FILE* file) {
    const off_t here = ftello(file);
    if (here < 0 || fseeko(file, 0, SEEK_END) != 0) return 0;
    const off_t size = ftello(file);
    return fseeko(file, here, SEEK_SET) == 0 && size > 0 ? static_cast<std::uint64_t>(size) : 0;
}

// Throws where a file of so many bytes is too short for its pixels, however well they are packed. least: the fewest
// bytes that they can take.
inline void checkAnnounced(int width, int height, double least, std::uint64_t bytes) {
    if (least > static_cast<double>(bytes))
        failReading("it announces " + std::to_string(width) + " x " + std::to_string(height) + " pixels and has " +
                    std::to_string(bytes) + " bytes");
}

}  // namespace image
