// Strips of a picture, rendered one by one, put together.
#pragma once

#include "image/image.h"

#include <string>

namespace render {

// A picture as read, and the file's name.
struct Strip {
    std::string path;
    image::Image image;
};

// The whole picture, of all its strips in any order; written to a file it makes the bytes of the same render in one
// piece. Throws core::Error, which names the file, for what no gr_render with startline and stopline has written, for
// strips of different renders, for lines that two strips have, and for lines that none has.
image::Image assemble(std::vector<Strip> strips);

}  // namespace render
