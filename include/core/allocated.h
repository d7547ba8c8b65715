// How much memory things take from the allocator.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

namespace core {

// What an allocation of so many bytes takes with glibc: the size stands in front, in steps of 16 bytes.
constexpr std::size_t allocatedBytes(std::size_t asked) {
    return std::max<std::size_t>((asked + sizeof(std::size_t) + 15) / 16 * 16, 32);
}

// A string's own letters, which a short one holds within itself.
inline std::size_t allocatedBytes(const std::string& text) {
    return text.capacity() > std::string().capacity() ? allocatedBytes(text.capacity() + 1) : 0;
}

// A std::unordered_map's or set's buckets (a table of one holds it within itself) and elements, each with a link to the
// next and its hash; not what the elements themselves allocate.
template<class Table>
std::size_t allocatedByTable(const Table& table) {
    const std::size_t element = sizeof(typename Table::value_type) + sizeof(void*) + sizeof(std::size_t);
    const std::size_t buckets = table.bucket_count() > 1 ? allocatedBytes(table.bucket_count() * sizeof(void*)) : 0;
    return buckets + table.size() * allocatedBytes(element);
}

}  // namespace core
