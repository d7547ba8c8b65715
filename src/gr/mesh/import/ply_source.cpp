#include "gr/mesh/import/ply_source.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace gr::importer {
namespace {

std::uint64_t lengthOf(double number, const PlyElement& element) {
    if (!(number >= 0 && number <= std::numeric_limits<int>::max() && number == std::floor(number)))
        throw Failure("a list of its " + shown(element.name) + " elements has no length that can be");
    return static_cast<std::uint64_t>(number);
}

}  // namespace

bool PlySource::next(const PlyElement& element, ElementNumbers& into) {
    into.numbers.clear();
    into.ends.clear();
    return format_ == PlyHeader::Format::text ? nextOfText(element, into) : nextOfBytes(element, into);
}

template<class Number>
double PlySource::take() {
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), data_.data(), sizeof(Number));
    data_.remove_prefix(sizeof(Number));
    if (format_ == PlyHeader::Format::bigEndian) std::reverse(bytes.begin(), bytes.end());
    static_assert(std::endian::native == std::endian::little);
    return static_cast<double>(std::bit_cast<Number>(bytes));
}
double PlySource::takeNumber(PlyType type) {
    switch (type) {
        case PlyType::int8:
            return take<std::int8_t>();
        case PlyType::uint8:
            return take<std::uint8_t>();
        case PlyType::int16:
            return take<std::int16_t>();
        case PlyType::uint16:
            return take<std::uint16_t>();
        case PlyType::int32:
            return take<std::int32_t>();
        case PlyType::uint32:
            return take<std::uint32_t>();
        case PlyType::float32:
            return take<float>();
        case PlyType::float64:
            break;
    }
    return take<double>();
}

bool PlySource::nextOfBytes(const PlyElement& element, ElementNumbers& into) {
    for (const PlyProperty& property : element.properties) {
        std::uint64_t count = 1;
        if (property.isList) {
            if (data_.size() < sizeOf(property.countType)) return false;
            count = lengthOf(takeNumber(property.countType), element);
        }
        if (count > data_.size() / sizeOf(property.type)) return false;
        for (std::uint64_t i = 0; i < count; ++i) into.numbers.push_back(takeNumber(property.type));
        into.ends.push_back(into.numbers.size());
    }
    return true;
}

// As text each element is a line.
bool PlySource::nextOfText(const PlyElement& element, ElementNumbers& into) {
    std::string_view line;
    do {
        if (!lines_.next(line)) return false;
    } while (trimmed(line).empty());
    for (const PlyProperty& property : element.properties) {
        std::uint64_t count = property.isList ? lengthOf(numberOf(line, property), element) : 1;
        for (; count > 0; --count) into.numbers.push_back(numberOf(line, property));
        into.ends.push_back(into.numbers.size());
    }
    if (!trimmed(line).empty()) fail("\"" + shown(takeWord(line)) + "\" is more than the header announces");
    return true;
}

double PlySource::numberOf(std::string_view& line, const PlyProperty& property) const {
    const std::string_view word = takeWord(line);
    double number;
    if (word.empty()) fail("it ends before the property " + shown(property.name));
    if (!readNumber(word, number)) fail("\"" + shown(word) + "\" is not a number");
    return number;
}

void PlySource::fail(const std::string& what) const {
    throw Failure("line " + std::to_string(headerLines_ + lines_.number()) + ": " + what);
}

}  // namespace gr::importer
