#include "core/any_order_sum.h"

#include <charconv>

namespace core {

std::string AnyOrderSum::text() const {
    std::string text;
    for (const auto& [size, count] : counts_)
        text += (text.empty() ? "" : ",") + std::to_string(size) + ":" + std::to_string(count);
    return text.empty() ? "0:0" : text;
}

std::optional<AnyOrderSum> AnyOrderSum::fromText(std::string_view text) {
    AnyOrderSum sum;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        int size = 0;
        std::uint64_t count = 0;
        const auto sizeRead = std::from_chars(at, end, size);
        if (sizeRead.ec != std::errc() || size < -200 || size > 200 || sizeRead.ptr == end || *sizeRead.ptr != ':')
            return std::nullopt;
        const auto countRead = std::from_chars(sizeRead.ptr + 1, end, count);
        if (countRead.ec != std::errc()) return std::nullopt;
        if (count > 0) sum.counts_[size] += count;
        if (countRead.ptr == end) return sum;
        if (*countRead.ptr != ',') return std::nullopt;
        at = countRead.ptr + 1;
    }
}

}  // namespace core
