// An OpenEXR file as OpenEXR's C++ library reads it; only grsh_exr is linked to that.
#pragma once

#include "image/image.h"

#include <memory>
#include <span>

namespace image::exr {

// The file's first part that holds a picture. Throws core::Error, whose message tells why, for what is not read.
class ExrFile {
public:
    // bytes: all of the file's; they must stay where they are.
    explicit ExrFile(std::span<char> bytes);
    ~ExrFile();

    // The picture without its numbers: its channels are empty.
    const Image& image() const { return image_; }
    // Lines that are best read at once, as many as the file keeps together or more.
    int linesAtOnce() const;
    // How many bytes reading it by so many threads takes at most, beside the file's own; 0: by the caller alone.
    double memory(int threads) const;
    // To be called before numbers are read.
    void start(int threads);
    // From the line on, counted from the top of what is held: `lines` lines of each channel.
    void read(int line, int lines, std::vector<std::vector<float>>& channels);

private:
    struct Library;

    void open(std::span<char> bytes);
    void readColours(int line, int lines, std::vector<std::vector<float>>& channels);

    std::unique_ptr<Library> library_;
    Image image_;
};

}  // namespace image::exr
