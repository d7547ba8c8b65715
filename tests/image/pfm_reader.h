// A portable float map as it is. https://netpbm.sourceforge.net/doc/pfm.html
#pragma once

#include "core/vec.h"
#include "image/temporary_folder.h"

#include <cstring>
#include <sstream>

namespace image {

struct Pfm {
    int width = 0, height = 0;
    double scale = 0;
    std::vector<core::Rgbf> pixels;  // from the top

    // Throws std::runtime_error for what is no such file of three colours, or has not its length.
    explicit Pfm(const std::string& path) {
        const std::string bytes = bytesOf(path);
        std::istringstream file(bytes);
        std::string kind;
        file >> kind >> width >> height >> scale;
        const std::size_t start = static_cast<std::size_t>(file.tellg()) + 1;  // behind one character of white space
        const std::size_t line = static_cast<std::size_t>(width), count = line * static_cast<std::size_t>(height);
        if (kind != "PF" || bytes.size() != start + count * sizeof(core::Rgbf)) throw std::runtime_error("no PFM");
        pixels.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t fromTop = (static_cast<std::size_t>(height) - 1 - i / line) * line + i % line;
            std::memcpy(&pixels[fromTop], &bytes[start + i * sizeof(core::Rgbf)], sizeof(core::Rgbf));
        }
    }
    const core::Rgbf& at(int x, int y) const { return pixels.at(static_cast<std::size_t>(y * width + x)); }
};

}  // namespace image
