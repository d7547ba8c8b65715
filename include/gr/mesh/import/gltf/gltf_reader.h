// glTF 2.0, as JSON text with its buffers beside it (.gltf) or in one file (.glb).
#pragma once

#include "gr/mesh/import/source_mesh.h"

#include <functional>
#include <string_view>

namespace gr::importer {

// Gives the bytes of a file that lies below the glTF file's own folder. path: relative to that folder, parted by '/',
// without percent signs that stand for other characters, and without "." and "..". The bytes stay where they are as
// long as the reader runs. Throws Failure where there is no such file; its words follow "its buffer 0: ".
using OtherFile = std::function<std::string_view(const std::string& path)>;

// Both give all faces of the file's scene: its default one, or its first one, or all nodes where there are no scenes.
// Meshes stand as they do before any animation begins. Lengths are the file's, which are metres; y is upwards.
// Materials, pictures, lights and cameras are not read. Both throw Failure, and std::bad_alloc.
SourceMesh readGltf(std::string_view file, const OtherFile& others);
SourceMesh readGlb(std::string_view file, const OtherFile& others);

}  // namespace gr::importer
