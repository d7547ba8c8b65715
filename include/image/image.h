// A picture as its file has it: the numbers of every channel, and what the file says of itself.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace image {

// What made the picture, as keyword and value; the same for two runs of the same render.
using Metadata = std::vector<std::pair<std::string, std::string>>;

// Pixel after pixel, line after line from the top: 8 or 16 bits of a PNG, or floats.
using PixelNumbers = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

struct ImageChannel {
    std::string
        name;  // R, G, B; Y of a grey picture; A: how much a pixel covers; and whatever else an OpenEXR file has
    PixelNumbers samples;
};

struct Window {
    int left = 0, top = 0, width = 0, height = 0;  // in pixels, y counted downwards

    bool operator==(const Window&) const = default;
};

struct Image {
    Window held;  // what it has of the whole picture
    Window whole;  // of a PNG, which does not tell its size: as if nothing were right of it or below
    bool isPart = false;  // whether the file says where it belongs
    std::vector<ImageChannel> channels;  // all of the same kind of samples
    Metadata metadata;
    // What light was raised to for whole numbers, as a PNG's gAMA says; 0: they went through the curve of sRGB.
    double gamma = 0;
    int partsLeftOut = 0;  // parts that the file has beside this one

    std::size_t pixels() const { return static_cast<std::size_t>(held.width) * static_cast<std::size_t>(held.height); }
    const ImageChannel* find(const std::string& name) const;  // null where there is none
    std::string channelNames() const;  // R G B
};

// Throws core::Error when a picture would take more memory than there is.
void checkMemory(const Window& held, double bytesPerPixel);

}  // namespace image
