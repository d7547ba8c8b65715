// The picture while it is being made: linear radiance.
#pragma once

#include "core/vec.h"

#include <vector>

namespace render {

// The lines startLine to startLine + lines - 1 of a picture of width x height pixels.
class Film {
public:
    Film(int width, int height, int startLine, int lines)
        : width_(width),
          height_(height),
          startLine_(startLine),
          lines_(lines),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(lines)) {}

    int width() const { return width_; }
    int height() const { return height_; }
    int startLine() const { return startLine_; }
    int lines() const { return lines_; }

    // x, y: in the whole picture, y counted from its top.
    core::Rgbf& at(int x, int y) { return pixels_[index(x, y)]; }
    const core::Rgbf& at(int x, int y) const { return pixels_[index(x, y)]; }

    static double bytesFor(int width, int lines) { return double{sizeof(core::Rgbf)} * width * lines; }
    std::size_t bytes() const { return pixels_.size() * sizeof(core::Rgbf); }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - startLine_) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    int width_, height_, startLine_, lines_;
    std::vector<core::Rgbf> pixels_;
};

}  // namespace render
