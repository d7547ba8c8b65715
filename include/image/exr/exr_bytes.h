// A file's bytes, as OpenEXR's C++ library wants to be given them, and the order of its attributes, which the library
// does not keep.
#pragma once

#include <ImfIO.h>

#include <span>
#include <string>
#include <vector>

namespace image::exr {

class ByteStream final : public Imf::IStream {
public:
    explicit ByteStream(std::span<char> bytes) : IStream("picture"), bytes_(bytes) {}

    bool isMemoryMapped() const override { return true; }
    char* readMemoryMapped(int count) override;
    bool read(char* to, int count) override;
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t at) override { at_ = at; }

    std::span<char> bytes() const { return bytes_; }
    // Whether something was asked for that is not there.
    bool hasEnded() const { return hasEnded_; }

private:
    std::span<char> bytes_;
    std::uint64_t at_ = 0;
    bool hasEnded_ = false;
};

// The names of each part's attributes, as the file has them one after the other. Throws core::Error where one of them
// does not end within the file: the library would reserve memory for it first.
std::vector<std::vector<std::string>> attributeNames(std::span<const char> file);

}  // namespace image::exr
