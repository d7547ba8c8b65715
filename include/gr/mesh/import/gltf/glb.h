// The parts of a .glb file.
#pragma once

#include <optional>
#include <string_view>

namespace gr::importer {

struct GlbParts {
    std::string_view json;
    std::optional<std::string_view> binary;
};

// Throws Failure where it is no .glb file of glTF 2, or not a whole one.
GlbParts partsOfGlb(std::string_view file);

}  // namespace gr::importer
