// KHR_draco_mesh_compression: vertices and triangles that Draco has packed.
#pragma once

#include "gr/mesh/import/gltf/accessor.h"

#include <map>

namespace gr::importer {

struct DracoMesh {
    std::size_t vertexCount = 0;
    std::vector<std::uint32_t> indices;  // three for each triangle
    std::map<std::string, Accessor> attributes;  // by glTF's names, such as "POSITION"
};

// extension: the object of that name. What Draco's numbers mean stands in the file's accessors, which are normalised or
// are not. place: of the primitive.
DracoMesh unpackDraco(const JsonObject& extension, std::string_view packed, const std::string& place);

}  // namespace gr::importer
