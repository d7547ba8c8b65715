// How much a script may use.
#pragma once

#include <cstdint>
#include <optional>

namespace grsh {

struct Limits {
    std::optional<double> seconds;  // of the whole process
    std::optional<std::uint64_t> bytes;  // of its memory
    std::optional<std::uint64_t> pixels;  // of a picture
    std::optional<int> samples;  // of a pixel
};

// Limits the memory that the process may have.
void limitMemory(std::uint64_t bytes);

}  // namespace grsh
