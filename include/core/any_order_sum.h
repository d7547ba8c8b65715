// A sum that is the same to the bit in whatever order its numbers come, and from however many parts it is put together.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace core {

// Whole numbers add up exactly. So each number is counted in units of 2^-24 of its size, those of like size together.
class AnyOrderSum {
public:
    // x: finite and at least 0. There is room for 2^32 numbers.
    void add(double x) {
        if (x == 0) return;
        const int size = std::ilogb(x) >> sizeBits;
        counts_[size] += static_cast<std::uint64_t>(std::scalbn(x, -unit(size)));
    }
    AnyOrderSum& operator+=(const AnyOrderSum& other) {
        for (const auto& [size, count] : other.counts_) counts_[size] += count;
        return *this;
    }
    double value() const {
        double sum = 0;
        for (const auto& [size, count] : counts_) sum += std::scalbn(static_cast<double>(count), unit(size));
        return sum;
    }

    // "size:count,size:count", in which nothing is lost, and the way back; nothing for what is no such text.
    std::string text() const;
    static std::optional<AnyOrderSum> fromText(std::string_view text);

    bool operator==(const AnyOrderSum&) const = default;

private:
    static constexpr int sizeBits = 3;
    // The exponent of the unit that numbers from 2^(8 size) to 2^(8 size + 8) are counted in.
    static int unit(int size) { return (size << sizeBits) - 24; }

    std::map<int, std::uint64_t> counts_;
};

}  // namespace core
