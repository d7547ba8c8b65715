// grsh_exr: reads an OpenEXR file, which is open for it, and writes its picture; see include/image/exr_message.h.
#include "core/reader_child.h"
#include "image/announced.h"
#include "image/exr/exr_file.h"
#include "image/exr_message.h"

#include <ImfThreading.h>

#include <malloc.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <thread>

namespace {

namespace reader = core::reader;

// Its own copy of what it changes: the library may turn bytes round where they are.
std::span<char> mapped(int file) {
    struct stat status;
    if (fstat(file, &status) != 0) image::failReading(std::strerror(errno));
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size == 0) image::failReading("it is empty");
    void* const data = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE, file, 0);
    if (data == MAP_FAILED) image::failReading(std::strerror(errno));
    return {static_cast<char*>(data), size};
}

void putText(const std::string& text) {
    const auto length = static_cast<std::uint32_t>(text.size());
    reader::put(&length, sizeof length);
    reader::put(text.data(), text.size());
}

void putHeader(const image::Image& image, int linesAtOnce) {
    const image::ExrMessage message{.held = image.held,
                                    .whole = image.whole,
                                    .partsLeftOut = image.partsLeftOut,
                                    .linesAtOnce = linesAtOnce,
                                    .channels = static_cast<std::uint32_t>(image.channels.size()),
                                    .texts = static_cast<std::uint32_t>(image.metadata.size())};
    reader::putSuccess();
    reader::put(&message, sizeof message);
    for (const image::ImageChannel& channel : image.channels) putText(channel.name);
    for (const auto& [name, value] : image.metadata) {
        putText(name);
        putText(value);
    }
}

// What the library packs together it can unpack on a thread each. Where there is too little memory for them it goes
// without.
int startThreads(const image::exr::ExrFile& file, double megabytes) {
    const int threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 4u));
    if (file.memory(threads) > megabytes * 1e6) return 0;
    try {
        Imf::setGlobalThreadCount(threads);
        return threads;
    } catch (const std::exception&) {
        Imf::setGlobalThreadCount(0);
        return 0;
    }
}

void readFile(const reader::Limits& most) {
    const std::span<char> bytes = mapped(reader::input);
    mallopt(M_ARENA_MAX, 1);
    // The program itself takes some, and headers may be as large as the file.
    const double start = 200 + 8 * static_cast<double>(bytes.size()) / 1e6;
    reader::limitMemory(std::min(most.megabytes, start));
    image::exr::ExrFile file(bytes);
    const int threads = startThreads(file, most.megabytes - start);
    reader::limitMemory(std::min(most.megabytes, start + file.memory(threads) / 1e6));
    file.start(threads);
    const image::Image& image = file.image();
    const int lines = file.linesAtOnce();
    putHeader(image, lines);
    std::vector<std::vector<float>> channels;
    for (int line = 0; line < image.held.height; line += lines) {
        file.read(line, std::min(lines, image.held.height - line), channels);
        reader::putSuccess();
        for (const std::vector<float>& numbers : channels) reader::put(numbers);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != reader::firstWord) return 2;
    const reader::Limits most = reader::begin(argv);
    reader::confineTo(-1);
    try {
        readFile(most);
    } catch (const std::bad_alloc&) {
        reader::putError("it asks for more memory than a file of its size should");
    } catch (const std::exception& error) {
        reader::putError(error.what());
    }
    _exit(0);  // without giving back what is given back anyway
}
