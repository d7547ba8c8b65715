// Links: exr_file
#include "core/error.h"
#include "image/exr/exr_file.h"

#include <algorithm>
#include <cstdlib>
#include <new>

// The library reserves what a file announces before it looks whether that is there. The limit of grsh_exr's memory
// refuses that; so does this.
namespace {

void* reserve(std::size_t size) {
    constexpr std::size_t most = 300'000'000;
    void* const memory = size > most ? nullptr : std::malloc(size);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return reserve(size);
}
void* operator new[](std::size_t size) {
    return reserve(size);
}
extern "C" const char* __asan_default_options() {
    return "alloc_dealloc_mismatch=0";
}

// As grsh_exr does it, with less memory.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    constexpr double mostMemory = 2e8;
    constexpr std::size_t mostPixels = 1'000'000;
    std::vector<char> copy(bytes, bytes + size);
    try {
        image::exr::ExrFile file(copy);
        const image::Image& image = file.image();
        if (file.memory(0) > mostMemory || image.pixels() * image.channels.size() > mostPixels) return 0;
        file.start(0);
        std::vector<std::vector<float>> channels;
        const int lines = file.linesAtOnce();
        for (int line = 0; line < image.held.height; line += lines) {
            file.read(line, std::min(lines, image.held.height - line), channels);
            if (channels.size() != image.channels.size()) std::abort();
        }
    } catch (const core::Error&) {
    } catch (const std::bad_alloc&) {
    }
    return 0;
}
