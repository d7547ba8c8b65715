// Pictures on disk: complete, or not there.
#pragma once

#include "image/film.h"
#include "image/image.h"

#include <filesystem>

namespace image {

// The sRGB curve (IEC 61966-2-1) and its inverse. Both are from 0 to 1.
double encodeSrgb(double linear);
double decodeSrgb(double encoded);
// The curve, rounded to 8 bits. radiance: linear; below 0 is 0, above 1 is 255.
std::uint8_t toSrgb8(float radiance);

// A picture that is going to be written, in the format that the path's ending names. Throws core::Error at once when
// that cannot work: an ending of no format, or of one that holds no layers, a folder that is not there or not writable,
// a name that is something other than a file.
class ImageFile {
public:
    // layers: what the film will have.
    explicit ImageFile(const std::string& path, std::span<const Layer> layers = {});

    // exposure: in stops; formats of linear radiance have no use for it. The file is written beside its place and then
    // renamed. Throws core::Error when the disk is full or the like; nothing is left behind then.
    void write(const Film& film, double exposure, const Metadata& metadata) const;
    // A picture that was read, from a file with the same ending.
    void write(const Image& image) const;

    // Throws core::Error where the file would replace that one, by whatever name;
    void checkIsNot(const std::string& input) const;
    // and also where it has another ending.
    void checkAgainst(const std::string& input) const;

private:
    template<class Write>
    void writeWith(const Write& write) const;

    std::string path_;  // as given, for messages
    std::filesystem::path target_;  // where links lead
};

// Reads a picture in the format that the path's ending names. Throws core::Error, which names the file, for what is not
// there or not whole.
Image readImage(const std::string& path);

}  // namespace image
