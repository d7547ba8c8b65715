// Whether the parts of a picture cover it, each pixel once.
#pragma once

#include "image/image.h"

#include <string>
#include <vector>

namespace render {

// What a file has of a picture.
struct Part {
    std::string path;
    image::Window window;  // within the picture
};

// Parts: in any order. Throws core::Error, which names the files, for pixels that two parts have, and for pixels that
// none has.
void checkCover(std::vector<Part> parts, int width, int height);

// line 4, lines 4 to 5, columns 0 to 15
std::string rangeText(const std::string& what, int first, int last);

}  // namespace render
