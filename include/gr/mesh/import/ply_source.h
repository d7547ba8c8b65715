// The elements of a PLY file, one after the other.
#pragma once

#include "gr/mesh/import/ply_header.h"
#include "gr/mesh/import/text.h"

#include <span>

namespace gr::importer {

// The numbers of all properties of one element, as doubles, which hold each of PLY's types.
struct ElementNumbers {
    std::vector<double> numbers;
    std::vector<std::size_t> ends;  // of each property in `numbers`

    std::span<const double> of(int property) const {
        const auto i = static_cast<std::size_t>(property);
        const std::size_t begin = i == 0 ? 0 : ends[i - 1];
        return {numbers.data() + begin, ends[i] - begin};
    }
};

class PlySource {
public:
    // data: what follows the header.
    PlySource(std::string_view data, const PlyHeader& header)
        : data_(data), lines_(data), format_(header.format), headerLines_(header.lines) {}

    // False when there is too little left for one. Throws Failure for what is no element of that kind.
    bool next(const PlyElement& element, ElementNumbers& into);

private:
    bool nextOfBytes(const PlyElement& element, ElementNumbers& into);
    template<class Number>
    double take();
    double takeNumber(PlyType type);

    bool nextOfText(const PlyElement& element, ElementNumbers& into);
    double numberOf(std::string_view& line, const PlyProperty& property) const;
    [[noreturn]] void fail(const std::string& what) const;

    std::string_view data_;  // that is left, of bytes
    TextLines lines_;
    PlyHeader::Format format_;
    int headerLines_;
};

}  // namespace gr::importer
