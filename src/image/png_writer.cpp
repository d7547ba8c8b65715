#include "core/error.h"
#include "image/curve.h"
#include "image/image_writers.h"
#include "image/primaries.h"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace image {

namespace {

// libpng reports errors by a function that must not return. It throws; libpng's own frames hold nothing to clean up
// but what png_destroy_write_struct frees.
[[noreturn]] void pngError(png_structp, png_const_charp message) {
    throw core::Error("FILE", "WRITE", "", std::string("libpng: ") + message);
}
void pngWarning(png_structp, png_const_charp) {}

// libpng's own writing does not say why it failed.
void pngWrite(png_structp png, png_bytep bytes, std::size_t size) {
    std::FILE* file = static_cast<std::FILE*>(png_get_io_ptr(png));
    if (std::fwrite(bytes, 1, size, file) != size) throw core::Error("FILE", "WRITE", "", std::strerror(errno));
}
void pngFlush(png_structp) {}

struct PngHeader {
    Window held;
    bool isPart;
    int bitDepth, colourType;
    double gamma = 0;  // as Image's
};

class PngWriter {
public:
    explicit PngWriter(std::FILE* file)
        : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, pngError, pngWarning)) {
        info_ = png_create_info_struct(png_);
        png_set_write_fn(png_, file, pngWrite, pngFlush);
    }
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    void writeHeader(const PngHeader& header, const Metadata& metadata) {
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(header.held.width),
                     static_cast<png_uint_32>(header.held.height), header.bitDepth, header.colourType,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        setColours(header.gamma);
        if (header.isPart) png_set_oFFs(png_, info_, header.held.left, header.held.top, PNG_OFFSET_PIXEL);
        std::vector<png_text> texts;
        for (const auto& [keyword, value] : metadata) {
            png_text text{};
            const bool isAscii = std::all_of(value.begin(), value.end(), [](char c) { return c >= 0; });
            // tEXt is Latin-1; UTF-8 has a chunk of its own.
            text.compression = isAscii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
            text.key = const_cast<char*>(keyword.c_str());
            text.text = const_cast<char*>(value.c_str());
            (isAscii ? text.text_length : text.itxt_length) = value.size();
            texts.push_back(text);
        }
        png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
        png_write_info(png_, info_);
    }
    void writeRow(const std::vector<png_byte>& row) { png_write_row(png_, row.data()); }
    void end() { png_write_end(png_, nullptr); }

private:
    void setColours(double gamma) {
        if (gamma == 0) {
            png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_RELATIVE);
            return;
        }
        const Primaries& p = srgbPrimaries;
        png_set_cHRM(png_, info_, p[6], p[7], p[0], p[1], p[2], p[3], p[4], p[5]);
        png_set_gAMA(png_, info_, gamma);
    }

    png_structp png_;
    png_infop info_ = nullptr;
};

// A line of the channels, pixel after pixel; the more significant byte of 16 bits comes first.
void putLine(const Image& image, int y, std::vector<png_byte>& row) {
    const std::size_t width = static_cast<std::size_t>(image.held.width), start = static_cast<std::size_t>(y) * width;
    for (std::size_t c = 0; c < image.channels.size(); ++c) {
        if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&image.channels[c].samples)) {
            for (std::size_t x = 0; x < width; ++x) row[x * image.channels.size() + c] = (*bytes)[start + x];
            continue;
        }
        const auto& words = std::get<std::vector<std::uint16_t>>(image.channels[c].samples);
        for (std::size_t x = 0; x < width; ++x) {
            png_byte* sample = &row[2 * (x * image.channels.size() + c)];
            sample[0] = static_cast<png_byte>(words[start + x] >> 8);
            sample[1] = static_cast<png_byte>(words[start + x] & 0xFF);
        }
    }
}

}  // namespace

void writePng(std::FILE* file, const Film& film, const ViewTransform& view, const Metadata& metadata) {
    const Window& held = film.held();
    PngWriter png(file);
    png.writeHeader({held, film.isPart(), 8, PNG_COLOR_TYPE_RGB, gammaOf(view.curve)}, metadata);
    const float scale = static_cast<float>(std::exp2(view.exposure));
    std::vector<png_byte> row;
    for (int y = held.top; y < held.top + held.height; ++y) {
        row.clear();
        for (int x = held.left; x < held.left + held.width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                row.push_back(toByte(view.curve, film.at(x, y)[channel] * scale));
        png.writeRow(row);
    }
    png.end();
}

void writePng(std::FILE* file, const Image& image) {
    constexpr int colourTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                   PNG_COLOR_TYPE_RGB_ALPHA};
    const std::size_t channels = image.channels.size();
    const bool isDeep = std::holds_alternative<std::vector<std::uint16_t>>(image.channels[0].samples);
    PngWriter png(file);
    png.writeHeader({image.held, image.isPart, isDeep ? 16 : 8, colourTypes[channels - 1], image.gamma},
                    image.metadata);
    std::vector<png_byte> row(static_cast<std::size_t>(image.held.width) * channels * (isDeep ? 2 : 1));
    for (int y = 0; y < image.held.height; ++y) {
        putLine(image, y, row);
        png.writeRow(row);
    }
    png.end();
}

}  // namespace image
