// Links: image
#include "fuzz/bytes.h"
#include "image/image_readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::readPicture(bytes, size, image::readPfm);
    return 0;
}
