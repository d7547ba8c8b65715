#include "gr/mesh/import/ply_header.h"

#include "core/error.h"
#include "gr/mesh/import/text.h"

#include <algorithm>
#include <array>

namespace gr::importer {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr std::array<TypeName, 16> typeNames{{{"char", PlyType::int8},
                                              {"uchar", PlyType::uint8},
                                              {"short", PlyType::int16},
                                              {"ushort", PlyType::uint16},
                                              {"int", PlyType::int32},
                                              {"uint", PlyType::uint32},
                                              {"float", PlyType::float32},
                                              {"double", PlyType::float64},
                                              {"int8", PlyType::int8},
                                              {"uint8", PlyType::uint8},
                                              {"int16", PlyType::int16},
                                              {"uint16", PlyType::uint16},
                                              {"int32", PlyType::int32},
                                              {"uint32", PlyType::uint32},
                                              {"float32", PlyType::float32},
                                              {"float64", PlyType::float64}}};

PlyType typeNamed(std::string_view word) {
    for (const auto& [name, type] : typeNames)
        if (name == word) return type;
    throw Failure("its header has no such type as \"" + shown(word) + "\"");
}

PlyProperty propertyOf(std::string_view line) {
    PlyProperty property;
    std::string_view type = takeWord(line);
    if (type == "list") {
        property.isList = true;
        property.countType = typeNamed(takeWord(line));
        type = takeWord(line);
    }
    property.type = typeNamed(type);
    property.name = takeWord(line);
    return property;
}

PlyElement elementOf(std::string_view line) {
    PlyElement element;
    element.name = takeWord(line);
    const std::string_view word = takeWord(line);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), element.count);
    if (error != std::errc() || end != word.data() + word.size())
        throw Failure("its number of " + shown(element.name) + " elements is \"" + shown(word) +
                      "\", not a whole number");
    return element;
}

PlyHeader::Format formatOf(std::string_view word) {
    constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian", "binary_big_endian"};
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) throw Failure("its format is \"" + shown(word) + "\", not " + core::listed(names));
    return static_cast<PlyHeader::Format>(found - names.begin());
}

std::string announced(const PlyElement& element) {
    return "it announces " + std::to_string(element.count) + " " + shown(element.name) +
           (element.count == 1 ? " element" : " elements");
}

// Each element takes some bytes; of those with lists nobody knows yet how many more.
void checkAnnounced(const PlyHeader& header, std::size_t size) {
    const bool isText = header.format == PlyHeader::Format::text;
    for (const PlyElement& element : header.elements) {
        if (element.count == 0) continue;
        if (element.properties.empty()) throw Failure("its " + shown(element.name) + " elements have no properties");
        // The last number of a text need not have a blank behind it.
        const std::size_t most = (size + isText) / element.leastSize(isText);
        if (element.count > most)
            throw Failure(announced(element) + " and has room for " + std::to_string(most) + " at the most");
        size -= element.count * element.leastSize(isText) - isText;
    }
}

}  // namespace

std::size_t sizeOf(PlyType type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

std::size_t PlyElement::leastSize(bool isText) const {
    std::size_t size = 0;
    for (const PlyProperty& property : properties)
        size += isText ? 2 : sizeOf(property.isList ? property.countType : property.type);
    return size;
}

int PlyElement::find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == property) return static_cast<int>(i);
    return -1;
}

PlyHeader takePlyHeader(std::string_view& file) {
    TextLines lines(file);
    std::string_view line;
    if (!lines.next(line) || trimmed(line) != "ply") throw Failure("it does not begin with a line \"ply\"");
    // Numbers begin right behind the header's last line, which ends as the first one does.
    const std::string_view first = file.substr(0, file.size() - lines.rest().size());
    const bool endsInTwo = first.ends_with("\r\n"), endsInReturn = first.ends_with('\r');
    PlyHeader header;
    while (true) {
        const std::string_view rest = lines.rest();
        line = {};
        lines.next(line);
        std::string_view words = line;
        const std::string_view keyword = takeWord(words);
        if (keyword == "end_header") {
            file = rest.substr(std::min(line.size() + (endsInTwo ? 2 : 1), rest.size()));
            if (!endsInTwo && !endsInReturn && rest.substr(line.size()).starts_with("\r\n")) file.remove_prefix(1);
            break;
        }
        if (lines.rest().empty()) throw Failure("its header has no end");
        if (keyword == "format")
            header.format = formatOf(takeWord(words));
        else if (keyword == "element")
            header.elements.push_back(elementOf(words));
        else if (keyword == "property" && header.elements.empty())
            throw Failure("its header has a property without an element");
        else if (keyword == "property")
            header.elements.back().properties.push_back(propertyOf(words));
        // An older Blender leaves out the word "comment" of its first one, which can do no harm there.
        else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty() && !header.elements.empty())
            throw Failure("its header has no such keyword as \"" + shown(keyword) + "\"");
    }
    header.lines = lines.number();
    checkAnnounced(header, file.size());
    return header;
}

void failCutOff(const PlyElement& element, std::uint64_t found) {
    throw Failure(announced(element) + " and ends after " + std::to_string(found));
}

}  // namespace gr::importer
