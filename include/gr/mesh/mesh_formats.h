// The formats of mesh files: a file is what its name's ending says. To add one: its ending here, and what
// include/gr/mesh/import/readers.h asks for.
#pragma once

#include <array>
#include <string_view>

namespace gr {

inline constexpr std::array<std::string_view, 5> meshEndings{".obj", ".ply", ".stl", ".gltf", ".glb"};

}  // namespace gr
