// Pictures on disk: complete, or not there.
#pragma once

#include "core/open_below.h"
#include "core/srgb.h"
#include "image/curve.h"
#include "image/film.h"
#include "image/image.h"

#include <filesystem>
#include <memory>

namespace image {

using core::decodeSrgb;
using core::encodeSrgb;

// A file as messages call it, and where it is.
struct FileName {
    // Where its name says, links followed.
    FileName(const std::string& name) : name(name), path(name) {}
    // Where somebody has made sure of: a file that is open, or a place in a folder that is, where a link is replaced.
    FileName(const std::string& name, const std::string& path, core::Descriptor open)
        : name(name), path(path), open(std::make_shared<core::Descriptor>(std::move(open))) {}

    std::string name;
    std::string path;
    std::shared_ptr<const core::Descriptor> open;  // what the path goes through, or null
};

// A picture that is going to be written, in the format that the path's ending names. Throws core::Error at once when
// that cannot work: an ending of no format, or of one that holds no layers, a folder that is not there or not writable,
// a name that is something other than a file.
class ImageFile {
public:
    // layers: what the film will have.
    explicit ImageFile(const FileName& file, std::span<const Layer> layers = {});
    explicit ImageFile(const std::string& path, std::span<const Layer> layers = {})
        : ImageFile(FileName(path), layers) {}

    // Formats of linear radiance have no use for how it is to be viewed. The file is written beside its place and then
    // renamed. Throws core::Error when the disk is full or the like; nothing is left behind then.
    void write(const Film& film, const ViewTransform& view, const Metadata& metadata) const;
    // A picture that was read, from a file with the same ending.
    void write(const Image& image) const;

    // Throws core::Error where the file would replace that one, by whatever name;
    void checkIsNot(const FileName& input) const;
    // and also where it has another ending, or, for a format that is only read, one that holds no floats.
    void checkAgainst(const FileName& input) const;

private:
    template<class Write>
    void writeWith(const Write& write) const;

    FileName file_;
    std::filesystem::path target_;  // where links lead
};

// Throws core::Error where a name does not end as those of pictures that can be written do.
void checkEndingToWrite(const std::string& name);

// Whether a name ends as those of pictures that can be read do, and these endings as messages list them.
bool hasPictureEnding(const std::string& name);
std::string pictureEndings();

// Reads a picture in the format that the path's ending names. Throws core::Error, which names the file, for what is not
// there or not whole.
Image readImage(const FileName& file);
inline Image readImage(const std::string& path) {
    return readImage(FileName(path));
}

}  // namespace image
