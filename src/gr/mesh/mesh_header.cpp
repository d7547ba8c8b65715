// What files say of their own size, looked at before memory is reserved for it.
#include "core/error.h"
#include "gr/mesh/mesh_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>

namespace gr {
namespace {

using Text = std::string_view;

[[noreturn]] void fail(const std::string& reason) {
    throw core::Error("MESH", "FILE", "", reason);
}

std::string times(std::uint64_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// Cuts the first line off.
Text takeLine(Text& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    Text line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

Text takeWord(Text& line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const Text word = line.substr(0, line.find_first_of(" \t"));
    line.remove_prefix(word.size());
    return word;
}

std::uint64_t wholeNumber(Text word, const std::string& what) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size())
        fail("its " + what + " is \"" + std::string(word.substr(0, 40)) + "\", not a whole number");
    return number;
}

// PLY: elements of several kinds, one kind after the other, each with the same properties.
struct PlyProperty {
    std::size_t size = 0;  // in bytes
    std::size_t countSize = 0;  // of the number that tells how many of them follow; 0: there is one
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    Text format;
    std::vector<PlyElement> elements;
};

std::size_t plySize(Text type) {
    constexpr std::array<std::pair<Text, std::size_t>, 16> sizes{{{"char", 1},
                                                                  {"uchar", 1},
                                                                  {"short", 2},
                                                                  {"ushort", 2},
                                                                  {"int", 4},
                                                                  {"uint", 4},
                                                                  {"float", 4},
                                                                  {"double", 8},
                                                                  {"int8", 1},
                                                                  {"uint8", 1},
                                                                  {"int16", 2},
                                                                  {"uint16", 2},
                                                                  {"int32", 4},
                                                                  {"uint32", 4},
                                                                  {"float32", 4},
                                                                  {"float64", 8}}};
    for (const auto& [name, size] : sizes)
        if (name == type) return size;
    fail("its header has no such type as \"" + std::string(type.substr(0, 40)) + "\"");
}

PlyProperty plyProperty(Text line) {
    const Text type = takeWord(line);
    if (type != "list") return {plySize(type), 0};
    const std::size_t countSize = plySize(takeWord(line));
    return {plySize(takeWord(line)), countSize};
}

// Cuts the header off.
PlyHeader takePlyHeader(Text& file) {
    if (takeLine(file) != "ply") fail("it does not begin with a line \"ply\"");
    PlyHeader header;
    for (bool ended = false; !ended;) {
        if (file.empty()) fail("its header has no end");
        Text line = takeLine(file);
        const Text keyword = takeWord(line);
        if (keyword == "format") {
            header.format = takeWord(line);
        } else if (keyword == "element") {
            PlyElement& element = header.elements.emplace_back();
            element.name = takeWord(line);
            element.count = wholeNumber(takeWord(line), "number of " + element.name + " elements");
        } else if (keyword == "property") {
            if (header.elements.empty()) fail("its header has a property without an element");
            header.elements.back().properties.push_back(plyProperty(line));
        }
        ended = keyword == "end_header";
    }
    return header;
}

std::uint64_t listLength(Text bytes, bool isBigEndian) {
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        length = length << 8 | static_cast<unsigned char>(bytes[isBigEndian ? i : bytes.size() - 1 - i]);
    return length;
}

// Cuts one element off; false when there is too little left for it.
bool takePlyElement(const PlyElement& element, bool isBigEndian, Text& file) {
    for (const PlyProperty& property : element.properties) {
        std::uint64_t count = 1;
        if (property.countSize > 0) {
            if (file.size() < property.countSize) return false;
            count = listLength(file.substr(0, property.countSize), isBigEndian);
            file.remove_prefix(property.countSize);
        }
        if (count > file.size() / property.size) return false;
        file.remove_prefix(count * property.size);
    }
    return true;
}

[[noreturn]] void failCutOff(const PlyElement& element, std::uint64_t found) {
    fail("it announces " + times(element.count, element.name + " element") + " and ends after " +
         std::to_string(found));
}

void checkPly(Text file) {
    const PlyHeader header = takePlyHeader(file);
    const bool isAscii = header.format == "ascii", isBigEndian = header.format == "binary_big_endian";
    if (!isAscii && !isBigEndian && header.format != "binary_little_endian")
        fail("its format is \"" + std::string(header.format.substr(0, 40)) +
             "\", not ascii, binary_little_endian or binary_big_endian");
    for (const PlyElement& element : header.elements) {
        if (element.properties.empty()) {
            if (element.count > 0) fail("its " + element.name + " elements have no properties");
            continue;
        }
        for (std::uint64_t i = 0; i < element.count; ++i) {
            const bool isThere = isAscii ? !file.empty() : takePlyElement(element, isBigEndian, file);
            if (!isThere) failCutOff(element, i);
            if (isAscii) takeLine(file);
        }
    }
}

// STL: text, or 80 bytes of any kind, the number of triangles, and 50 bytes for each of them.
void checkStl(Text file) {
    constexpr std::size_t headerSize = 84, triangleSize = 50;
    const bool isNamedAsText =
        file.substr(std::min(file.find_first_not_of(" \t\r\n"), file.size())).starts_with("solid");
    std::uint64_t size = 0, count = 0;
    if (file.size() >= headerSize) {
        count = listLength(file.substr(80, 4), false);
        size = headerSize + triangleSize * count;
    }
    if (file.size() == headerSize && count == 0) fail("it has no faces");
    if (file.size() == size) return;
    if (isNamedAsText) {
        if (file.find("endsolid") == Text::npos) fail("it has no line \"endsolid\": its end is missing");
        return;
    }
    if (file.size() < headerSize) fail("it is shorter than the header of an STL file");
    fail("it announces " + times(count, "triangle") + ", which take " + std::to_string(size) + " bytes, and has " +
         std::to_string(file.size()));
}

// OBJ announces nothing, but a line that ends too early was cut off with what followed.
void checkObj(Text file) {
    while (file.ends_with('\n') || file.ends_with('\r')) file.remove_suffix(1);
    Text line = file.substr(file.rfind('\n') + 1);
    const Text keyword = takeWord(line);
    if (keyword != "v" && keyword != "vn" && keyword != "f") return;
    for (int i = 0; i < 3; ++i)
        if (takeWord(line).empty()) fail("its last line is cut off");
}

}  // namespace

void checkAnnounced(std::string_view file, std::string_view ending) {
    if (ending == ".obj") checkObj(file);
    if (ending == ".ply") checkPly(file);
    if (ending == ".stl") checkStl(file);
}

}  // namespace gr
