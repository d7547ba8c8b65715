#include "core/error.h"
#include "render/image_writers.h"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace render {

std::uint8_t toSrgb8(float radiance) {
    const double x = std::clamp(static_cast<double>(radiance), 0.0, 1.0);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(encoded * 255 + 0.5);
}

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

    void write(const Film& film, double exposure, const Metadata& metadata) {
        writeHeader(film, metadata);
        const float scale = static_cast<float>(std::exp2(exposure));
        std::vector<png_byte> row(3 * static_cast<std::size_t>(film.width()));
        for (int y = film.startLine(); y < film.startLine() + film.lines(); ++y) {
            for (int x = 0; x < film.width(); ++x)
                for (int channel = 0; channel < 3; ++channel)
                    row[3 * static_cast<std::size_t>(x) + static_cast<std::size_t>(channel)] =
                        toSrgb8(film.at(x, y)[channel] * scale);
            png_write_row(png_, row.data());
        }
        png_write_end(png_, nullptr);
    }

private:
    void writeHeader(const Film& film, const Metadata& metadata) {
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(film.width()), static_cast<png_uint_32>(film.lines()), 8,
                     PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_RELATIVE);
        if (film.lines() != film.height()) png_set_oFFs(png_, info_, 0, film.startLine(), PNG_OFFSET_PIXEL);
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

    png_structp png_;
    png_infop info_ = nullptr;
};

}  // namespace

void writePng(std::FILE* file, const Film& film, double exposure, const Metadata& metadata) {
    PngWriter(file).write(film, exposure, metadata);
}

}  // namespace render
