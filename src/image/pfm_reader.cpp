#include "image/announced.h"
#include "image/image_readers.h"

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace image {
namespace {

struct Header {
    std::size_t channels;
    int width, height;
    double scale;  // negative: the bytes are little endian
};

Header readHeader(std::FILE* file) {
    char kind[3] = "";
    Header header{};
    const int read = std::fscanf(file, "%2s %7d %7d %lf", kind, &header.width, &header.height, &header.scale);
    // One character of white space ends the header.
    const int end = read == 4 ? std::fgetc(file) : EOF;
    const std::string_view type(kind);
    if (read < 1 || (type != "PF" && type != "Pf"))
        failReading("it is no portable float map: it does not begin with PF or Pf");
    if (end != ' ' && (end < '\t' || end > '\r')) failReading("its header is broken");
    if (header.width < 1 || header.height < 1 || header.width > 1'000'000 || header.height > 1'000'000)
        failReading("its header says " + std::to_string(header.width) + " x " + std::to_string(header.height) +
                    " pixels");
    if (!std::isfinite(header.scale) || header.scale == 0) failReading("its header's scale is 0 or not finite");
    header.channels = type == "PF" ? 3 : 1;
    return header;
}

float numberFrom(std::uint32_t bits, const Header& header) {
    if (header.scale > 0) bits = __builtin_bswap32(bits);
    return std::bit_cast<float>(bits) * static_cast<float>(std::abs(header.scale));
}

}  // namespace

Image readPfm(std::FILE* file) {
    static_assert(std::endian::native == std::endian::little);
    const Header header = readHeader(file);
    Image image;
    image.held = image.whole = {0, 0, header.width, header.height};
    const std::uint64_t bytes = sizeOf(file), start = static_cast<std::uint64_t>(ftello(file));
    const double numbers = static_cast<double>(header.channels * sizeof(float)) * header.width * header.height;
    checkAnnounced(header.width, header.height, numbers + static_cast<double>(start), bytes);
    checkMemory(image.held, static_cast<double>(header.channels * sizeof(float)));
    std::vector<std::vector<float>> channels(header.channels, std::vector<float>(image.pixels()));
    const std::size_t width = static_cast<std::size_t>(header.width);
    std::vector<std::uint32_t> line(width * header.channels);
    // The bottom line comes first.
    for (std::size_t y = static_cast<std::size_t>(header.height); y-- > 0;) {
        if (std::fread(line.data(), sizeof line[0], line.size(), file) != line.size())
            failReading(std::ferror(file) != 0 ? std::strerror(errno) : "it ends too early");
        for (std::size_t i = 0; i < line.size(); ++i)
            channels[i % header.channels][y * width + i / header.channels] = numberFrom(line[i], header);
    }
    if (std::fgetc(file) != EOF) failReading("it goes on behind its last pixel");
    for (std::size_t c = 0; c < header.channels; ++c)
        image.channels.push_back({std::string(1, header.channels == 1 ? 'Y' : "RGB"[c]), std::move(channels[c])});
    return image;
}

}  // namespace image
