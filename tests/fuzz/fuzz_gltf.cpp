// Links: mesh_readers gr
// Seeds: tests/corpus/meshes/*.gltf tests/corpus/meshes/*.glb
#include "fuzz/mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace gr::importer;
    fuzz::readMesh(bytes, size, [](std::string_view file) {
        // Every other file is the file itself: whatever bytes there are can be a buffer, too.
        const OtherFile others = [&](const std::string& path) {
            if (path.starts_with("no")) throw Failure("there is no such file");
            return file;
        };
        return file.starts_with("glTF") ? readGlb(file, others) : readGltf(file, others);
    });
    return 0;
}
