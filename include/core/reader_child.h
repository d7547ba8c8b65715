// A program that reads files for grsh: what it is given and what it gives back. See core/reader_process.h.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace core::reader {

// Where it writes to, and where that is open which grsh has opened for it.
inline constexpr int channel = 3, input = 4;
// Its words: the most megabytes of memory, the most seconds, and what it is to do.
inline constexpr int firstWord = 3;

struct Limits {
    double megabytes, seconds;
};

// To be called first. The process ends when grsh does, and beyond its limits.
Limits begin(char** words);
// Beyond this a request for memory fails, or the process ends.
void limitMemory(double megabytes);
void limitSeconds(double seconds);

// From now on the process can read files below a folder that is open, and neither write nor run any: for what a file
// may bring a reader to that has a fault. Linux older than 5.13 cannot do that, and nothing happens. folder: -1: it can
// open no file at all.
void confineTo(int folder);

// What is before each part: that it is there, or why not.
void putSuccess();
void putError(std::string_view reason);
// The bytes of a part.
void put(const void* data, std::size_t bytes);
template<class T>
void put(const std::vector<T>& values) {
    put(values.data(), values.size() * sizeof(T));
}

}  // namespace core::reader
