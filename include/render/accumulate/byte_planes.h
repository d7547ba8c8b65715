// Numbers packed into few bytes, none of them lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace render {

// Of each number the bytes that are alike come to lie side by side, all first bytes, then all second ones, and so on:
// neighbouring pixels are about as bright, so that much is said again and again, and zlib says it once.
class PlanePacker {
public:
    template<class Number>
    void add(const std::vector<Number>& numbers) {
        for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
            for (const Number number : numbers) bytes_.push_back(static_cast<char>(number >> (8 * byte)));
    }
    std::string packed() const;

private:
    std::string bytes_;
};

class PlaneReader {
public:
    // size: that of the bytes before they were packed. Throws core::Error where that is not what is in them.
    PlaneReader(std::string_view packed, std::size_t size);

    template<class Number>
    std::vector<Number> next(std::size_t count) {
        std::vector<Number> numbers(count, 0);
        for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
            for (Number& number : numbers)
                number |= static_cast<Number>(static_cast<unsigned char>(bytes_[at_++])) << (8 * byte);
        return numbers;
    }

private:
    std::string bytes_;
    std::size_t at_ = 0;
};

std::uint32_t checksum(std::string_view bytes);  // CRC-32

}  // namespace render
