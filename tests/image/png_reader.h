// A PNG file as it is: its pixels, and all that it says of itself.
#pragma once

#include "image/temporary_folder.h"

#include <png.h>

#include <cstdio>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace image {

struct Png {
    int width = 0, height = 0;
    int bitDepth = 0, colourType = 0;
    std::vector<std::vector<png_byte>> lines;  // red, green, blue, pixel after pixel
    std::map<std::string, std::string> texts;
    std::map<std::string, int> compressions;  // how a text is kept: PNG_TEXT_COMPRESSION_NONE, ...
    std::optional<std::pair<int, int>> offset;
    std::optional<int> srgbIntent;
    double gamma = 0;
    std::vector<double> chromaticities;  // x and y of white, red, green, blue

    // Throws std::runtime_error for what is no PNG file, or not all of one.
    explicit Png(const std::string& path);

private:
    void readHeader(png_structp png, png_infop info);
    void readTexts(png_structp png, png_infop info);
};

inline Png::Png(const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) throw std::runtime_error("cannot read " + path);
    const auto fail = [](png_structp, png_const_charp message) { throw std::runtime_error(message); };
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, fail);
    png_infop info = png_create_info_struct(png);
    try {
        png_init_io(png, file);
        png_read_info(png, info);
        readHeader(png, info);
        for (int y = 0; y < height; ++y) {
            lines.emplace_back(png_get_rowbytes(png, info));
            png_read_row(png, lines.back().data(), nullptr);
        }
        png_read_end(png, info);
        readTexts(png, info);
    } catch (...) {
        png_destroy_read_struct(&png, &info, nullptr);
        std::fclose(file);
        throw;
    }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
}

inline void Png::readHeader(png_structp png, png_infop info) {
    width = static_cast<int>(png_get_image_width(png, info));
    height = static_cast<int>(png_get_image_height(png, info));
    bitDepth = png_get_bit_depth(png, info);
    colourType = png_get_color_type(png, info);
    png_int_32 x = 0, y = 0;
    int unit = 0, intent = 0;
    if (png_get_oFFs(png, info, &x, &y, &unit) != 0 && unit == PNG_OFFSET_PIXEL) offset = {x, y};
    if (png_get_sRGB(png, info, &intent) != 0) srgbIntent = intent;
    png_get_gAMA(png, info, &gamma);
    chromaticities.resize(8);
    double* c = chromaticities.data();
    if (png_get_cHRM(png, info, c, c + 1, c + 2, c + 3, c + 4, c + 5, c + 6, c + 7) == 0) chromaticities.clear();
}

inline void Png::readTexts(png_structp png, png_infop info) {
    png_textp text = nullptr;
    int count = 0;
    png_get_text(png, info, &text, &count);
    for (int i = 0; i < count; ++i) {
        if (!texts.emplace(text[i].key, text[i].text).second) throw std::runtime_error("a text twice");
        compressions[text[i].key] = text[i].compression;
    }
}

// The kinds of its chunks, in order: IHDR, ..., IEND. libpng makes up some that are not there.
inline std::vector<std::string> chunkKinds(const std::string& path) {
    const std::string bytes = bytesOf(path);
    std::vector<std::string> kinds;
    for (std::size_t at = 8; at + 8 <= bytes.size();) {
        const auto byte = [&](std::size_t i) { return std::size_t{static_cast<unsigned char>(bytes[at + i])}; };
        kinds.push_back(bytes.substr(at + 4, 4));
        at += 12 + (byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3));
    }
    return kinds;
}

}  // namespace image
