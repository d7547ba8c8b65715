#include "core/error.h"
#include "render/image_writers.h"

#include <bit>
#include <cerrno>
#include <cstring>

namespace render {

void writePfm(std::FILE* file, const Film& film, double, const Metadata&) {
    static_assert(std::endian::native == std::endian::little);
    const auto write = [&](const void* bytes, std::size_t size) {
        if (std::fwrite(bytes, 1, size, file) != size) throw core::Error("FILE", "WRITE", "", std::strerror(errno));
    };
    // A negative scale tells that the bytes are little endian.
    const std::string header = "PF\n" + std::to_string(film.width()) + " " + std::to_string(film.lines()) + "\n-1.0\n";
    write(header.data(), header.size());
    // The bottom line comes first.
    for (int y = film.startLine() + film.lines() - 1; y >= film.startLine(); --y)
        write(&film.at(0, y), static_cast<std::size_t>(film.width()) * sizeof(core::Rgbf));
}

}  // namespace render
