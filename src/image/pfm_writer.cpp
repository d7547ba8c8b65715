#include "core/error.h"
#include "image/image_writers.h"

#include <bit>
#include <cerrno>
#include <cstring>

namespace image {

namespace {

void write(std::FILE* file, const void* bytes, std::size_t size) {
    if (std::fwrite(bytes, 1, size, file) != size) throw core::Error("FILE", "WRITE", "", std::strerror(errno));
}

void writeHeader(std::FILE* file, std::string_view kind, int width, int lines) {
    static_assert(std::endian::native == std::endian::little);
    // A negative scale tells that the bytes are little endian.
    const std::string header =
        std::string(kind) + "\n" + std::to_string(width) + " " + std::to_string(lines) + "\n-1.0\n";
    write(file, header.data(), header.size());
}

}  // namespace

void writePfm(std::FILE* file, const Film& film, const ViewTransform&, const Metadata&) {
    const Window& held = film.held();
    writeHeader(file, "PF", held.width, held.height);
    // The bottom line comes first.
    for (int y = held.top + held.height - 1; y >= held.top; --y)
        write(file, &film.at(held.left, y), static_cast<std::size_t>(held.width) * sizeof(core::Rgbf));
}

void writePfm(std::FILE* file, const Image& image) {
    const std::size_t width = static_cast<std::size_t>(image.held.width), channels = image.channels.size();
    writeHeader(file, channels == 1 ? "Pf" : "PF", image.held.width, image.held.height);
    std::vector<float> line(width * channels);
    for (std::size_t y = static_cast<std::size_t>(image.held.height); y-- > 0;) {
        for (std::size_t i = 0; i < line.size(); ++i)
            line[i] = std::get<std::vector<float>>(image.channels[i % channels].samples)[y * width + i / channels];
        write(file, line.data(), line.size() * sizeof(float));
    }
}

}  // namespace image
