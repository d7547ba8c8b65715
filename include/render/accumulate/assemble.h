// Parts of a picture, rendered one by one, put together.
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
// piece. But columns that are cut elsewhere than at tileSize, 16, do not tell how noisy the whole is, and then it does
// not say that. Throws core::Error, which names the file, for what no gr_render with startline, startcolumn and the
// like has written, for strips of different renders, for pixels that two strips have, and for pixels that none has.
image::Image assemble(std::vector<Strip> strips);

}  // namespace render
