#include "image/announced.h"
#include "image/image_readers.h"
#include "image/png_colours.h"

#include <png.h>

#include <cerrno>
#include <cstring>

namespace image {
namespace {

// Texts may unpack to a thousand times their size.
constexpr png_alloc_size_t longestChunk = 32'000'000;
constexpr png_uint_32 mostTexts = 1000;

// As in png_writer.cpp: it throws, through frames that png_destroy_read_struct cleans up after.
[[noreturn]] void pngError(png_structp, png_const_charp message) {
    failReading(std::string("libpng: ") + message);
}
// The library leaves out what goes beyond its limits and only warns; no text of a picture gets lost here.
void pngWarning(png_structp, png_const_charp message) {
    const std::string_view text(message);
    const auto says = [&](std::string_view words) { return text.find(words) != text.npos; };
    const std::string chunk = "its " + std::string(text.substr(0, 4)) + " chunk ";
    const std::string limit = "takes more than " + std::to_string(longestChunk / 1'000'000) + " MB";
    if (says("chunk data is too large")) failReading(chunk + limit);
    // Of a text that is packed it does not tell which of the two it is.
    if (says("TXt: truncated") || says("insufficient memory") || says("out of memory"))
        failReading(chunk + "is cut off or " + limit);
    if (says("no space in chunk cache")) failReading("it has more than " + std::to_string(mostTexts) + " texts");
}

void pngRead(png_structp png, png_bytep bytes, std::size_t size) {
    std::FILE* file = static_cast<std::FILE*>(png_get_io_ptr(png));
    if (std::fread(bytes, 1, size, file) == size) return;
    failReading(std::ferror(file) != 0 ? std::strerror(errno) : "it ends too early");
}

// tEXt and zTXt hold Latin-1.
std::string utf8(const std::string& latin1) {
    std::string text;
    for (const char c : latin1) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            text += c;
        } else {
            text += static_cast<char>(0xC0 | byte >> 6);
            text += static_cast<char>(0x80 | (byte & 0x3F));
        }
    }
    return text;
}

class PngReader {
public:
    explicit PngReader(std::FILE* file)
        : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, pngError, pngWarning)) {
        info_ = png_create_info_struct(png_);
        png_set_read_fn(png_, file, pngRead);
        png_set_user_limits(png_, 1'000'000, 1'000'000);
        png_set_chunk_malloc_max(png_, longestChunk);
        png_set_chunk_cache_max(png_, mostTexts);
        keepColourChunks(png_);
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    // bytes: how many the file has.
    Image read(std::uint64_t bytes) {
        png_read_info(png_, info_);
        Image image;
        image.gamma = gammaOf(png_, info_);
        readPlace(image);
        // Deflate makes at most 1032 bytes of one.
        checkAnnounced(image.held.width, image.held.height,
                       static_cast<double>(png_get_rowbytes(png_, info_)) * image.held.height / 1032, bytes);
        png_set_expand(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        if (png_get_bit_depth(png_, info_) == 16)
            readChannels<std::uint16_t>(image);
        else
            readChannels<std::uint8_t>(image);
        png_read_end(png_, info_);
        readTexts(image);
        return image;
    }

private:
    void readPlace(Image& image) {
        image.held.width = static_cast<int>(png_get_image_width(png_, info_));
        image.held.height = static_cast<int>(png_get_image_height(png_, info_));
        png_int_32 x = 0, y = 0;
        int unit = 0;
        image.isPart = png_get_oFFs(png_, info_, &x, &y, &unit) != 0 && unit == PNG_OFFSET_PIXEL && x >= 0 && y >= 0 &&
                       x <= 1'000'000 && y <= 1'000'000;
        if (image.isPart) {
            image.held.left = x;
            image.held.top = y;
        }
        image.whole = {0, 0, image.held.left + image.held.width, image.held.top + image.held.height};
    }

    template<class Sample>
    void readChannels(Image& image) {
        const std::size_t channels = png_get_channels(png_, info_), lines = static_cast<std::size_t>(image.held.height);
        // Twice: as the file has them, and channel by channel.
        checkMemory(image.held, static_cast<double>(2 * channels * sizeof(Sample)));
        const std::size_t bytesPerLine = png_get_rowbytes(png_, info_);
        std::vector<png_byte> bytes(bytesPerLine * lines);
        std::vector<png_bytep> rows(lines);
        for (std::size_t y = 0; y < lines; ++y) rows[y] = &bytes[y * bytesPerLine];
        png_read_image(png_, rows.data());

        constexpr std::string_view names[] = {"Y", "YA", "RGB", "RGBA"};
        for (std::size_t c = 0; c < channels; ++c) {
            std::vector<Sample> samples(image.pixels());
            for (std::size_t i = 0; i < samples.size(); ++i) {
                const png_byte* sample = &bytes[(i * channels + c) * sizeof(Sample)];
                samples[i] = static_cast<Sample>(sizeof(Sample) == 1 ? sample[0] : sample[0] << 8 | sample[1]);
            }
            image.channels.push_back({std::string(1, names[channels - 1][c]), std::move(samples)});
        }
    }

    void readTexts(Image& image) {
        png_textp text = nullptr;
        int count = 0;
        png_get_text(png_, info_, &text, &count);
        for (int i = 0; i < count; ++i) {
            const bool isUtf8 = text[i].compression >= PNG_ITXT_COMPRESSION_NONE;
            image.metadata.emplace_back(text[i].key, isUtf8 ? std::string(text[i].text) : utf8(text[i].text));
        }
    }

    png_structp png_;
    png_infop info_ = nullptr;
};

}  // namespace

Image readPng(std::FILE* file) {
    const std::uint64_t bytes = sizeOf(file);
    return PngReader(file).read(bytes);
}

}  // namespace image
