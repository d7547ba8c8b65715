#include "gr/mesh/import/readers.h"

#include "gr/mesh/import/gltf/glb.h"
#include "gr/mesh/import/gltf/scene_placer.h"

namespace gr::importer {
namespace {

SourceMesh read(std::string_view json, std::optional<std::string_view> binary, const OtherFile& others) {
    const GltfDocument document(json);
    GltfBuffers buffers(document, binary, others);
    return ScenePlacer(document, buffers).build();
}

}  // namespace

SourceMesh readGltf(std::string_view file, const OtherFile& others) {
    if (file.starts_with("glTF")) throw Failure("it is a .glb file, by its first bytes: its name should end so");
    return read(file, {}, others);
}

SourceMesh readGlb(std::string_view file, const OtherFile& others) {
    const GlbParts parts = partsOfGlb(file);
    return read(parts.json, parts.binary, others);
}

}  // namespace gr::importer
