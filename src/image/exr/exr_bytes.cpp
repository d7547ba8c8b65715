#include "image/exr/exr_bytes.h"

#include "image/announced.h"

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

// Cuts so many bytes off.
std::span<const char> take(std::span<const char>& bytes, std::size_t count) {
    if (count > bytes.size()) failReading("it ends too early");
    const std::span<const char> taken = bytes.first(count);
    bytes = bytes.subspan(count);
    return taken;
}

// Cuts off a text that ends with 0.
std::string takeText(std::span<const char>& bytes) {
    const auto length = std::find(bytes.begin(), bytes.end(), '\0') - bytes.begin();
    const std::span<const char> text = take(bytes, static_cast<std::size_t>(length));
    take(bytes, 1);
    return {text.begin(), text.end()};
}

std::uint32_t takeNumber(std::span<const char>& bytes) {
    std::uint32_t number = 0;
    std::memcpy(&number, take(bytes, sizeof number).data(), sizeof number);
    return number;
}

}  // namespace

std::vector<std::vector<std::string>> attributeNames(std::span<const char> file) {
    constexpr std::uint32_t manyParts = 0x1000;
    take(file, 4);
    const bool isOnePart = (takeNumber(file) & manyParts) == 0;
    // In each header an attribute is its name, its type, its size and so many bytes; a name without a letter ends it,
    // and where there are many a header without attributes ends them.
    std::vector<std::vector<std::string>> parts(1);
    while (true) {
        std::string name = takeText(file);
        if (!name.empty()) {
            takeText(file);
            take(file, takeNumber(file));
            parts.back().push_back(std::move(name));
        } else if (isOnePart || parts.back().empty()) {
            return parts;
        } else {
            parts.emplace_back();
        }
    }
}

}  // namespace image::exr
