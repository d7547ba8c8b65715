// The header of a PLY file: elements of several kinds, one kind after the other, each with the same properties.
#pragma once

#include "gr/mesh/import/source_mesh.h"

#include <string_view>

namespace gr::importer {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t sizeOf(PlyType type);  // in bytes

struct PlyProperty {
    std::string name;
    PlyType type{};
    bool isList = false;
    PlyType countType{};  // of the number that tells how long a list is
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    // In bytes, the least that one of them takes in a file: binary, or as text, where a number has a digit and a blank.
    std::size_t leastSize(bool isText) const;
    int find(std::string_view property) const;  // its place, or -1
};

struct PlyHeader {
    enum class Format { text, littleEndian, bigEndian } format{};
    std::vector<PlyElement> elements;
    int lines = 0;
};

// Cuts the header off. Throws Failure for what is no header, and for one that announces more than follows it.
PlyHeader takePlyHeader(std::string_view& file);

// What has ended too early.
[[noreturn]] void failCutOff(const PlyElement& element, std::uint64_t found);

}  // namespace gr::importer
