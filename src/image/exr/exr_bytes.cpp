#include "image/exr/exr_bytes.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace image::exr {

char* ByteStream::readMemoryMapped(int count) {
    if (count < 0 || at_ > bytes_.size() || bytes_.size() - at_ < static_cast<std::uint64_t>(count)) {
        hasEnded_ = true;
        throw std::runtime_error("it ends too early");
    }
    char* const here = bytes_.data() + at_;
    at_ += static_cast<std::uint64_t>(count);
    return here;
}

bool ByteStream::read(char* to, int count) {
    const char* const from = readMemoryMapped(count);
    std::copy(from, from + count, to);
    return at_ < bytes_.size();
}

namespace {

// Cuts off a text that ends with 0.
std::string takeText(std::span<const char>& bytes) {
    const auto end = std::find(bytes.begin(), bytes.end(), '\0');
    std::string text(bytes.begin(), end);
    bytes = bytes.subspan(std::min(text.size() + 1, bytes.size()));
    return text;
}

std::uint32_t takeNumber(std::span<const char>& bytes) {
    std::uint32_t number = 0;
    if (bytes.size() >= sizeof number) std::memcpy(&number, bytes.data(), sizeof number);
    bytes = bytes.subspan(std::min(sizeof number, bytes.size()));
    return number;
}

}  // namespace

std::vector<std::string> attributeNames(std::span<const char> file, int part) {
    // Headers follow the magic number and the version. In each an attribute is its name, its type, its size and so many
    // bytes; a name without a letter ends it.
    std::span<const char> rest = file.subspan(std::min<std::size_t>(8, file.size()));
    std::vector<std::string> names;
    while (!rest.empty()) {
        std::string name = takeText(rest);
        if (name.empty()) {
            if (part-- == 0) break;
            names.clear();
            continue;
        }
        takeText(rest);
        rest = rest.subspan(std::min<std::size_t>(takeNumber(rest), rest.size()));
        names.push_back(std::move(name));
    }
    return names;
}

}  // namespace image::exr
