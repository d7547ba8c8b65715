// Links: image
#include "fuzz/bytes.h"
#include "image/image_readers.h"
#include "image/image_writers.h"

#include <zlib.h>

#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* bytes, std::size_t size, std::size_t most);

namespace {

std::uint32_t bigEndian(const std::uint8_t* at) {
    return std::uint32_t{at[0]} << 24 | std::uint32_t{at[1]} << 16 | std::uint32_t{at[2]} << 8 | at[3];
}

// What was read can be written, and is then read as it was.
void checkRewriting(const image::Image& image) {
    char* bytes = nullptr;
    std::size_t size = 0;
    {
        const fuzz::File file(open_memstream(&bytes, &size), std::fclose);
        image::writePng(file.get(), image);
    }
    const std::unique_ptr<char, decltype(&std::free)> held(bytes, std::free);
    const image::Image again = image::readPng(fuzz::fileOf(reinterpret_cast<std::uint8_t*>(bytes), size).get());
    for (std::size_t c = 0; c < image.channels.size(); ++c)
        if (again.channels.at(c).samples != image.channels[c].samples) std::abort();
}

}  // namespace

// With a checksum that is wrong the library looks no further.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t size, std::size_t most, unsigned) {
    size = LLVMFuzzerMutate(bytes, size, most);
    for (std::size_t at = 8; at + 12 <= size;) {
        const std::size_t length = bigEndian(bytes + at);
        if (length > size - at - 12) break;
        const std::uint32_t sum = static_cast<std::uint32_t>(crc32(0, bytes + at + 4, static_cast<uInt>(length + 4)));
        for (unsigned i = 0; i < 4; ++i) bytes[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        at += length + 12;
    }
    return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::readPicture(bytes, size, [](std::FILE* file) {
        image::Image image = image::readPng(file);
        checkRewriting(image);
        return image;
    });
    return 0;
}
