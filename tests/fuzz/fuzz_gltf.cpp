// Any bytes are a glTF file that is read, or one that is refused: nothing else may come of them.
#include "gr/mesh/import/gltf/gltf_reader.h"

#include <new>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace gr::importer;
    const std::string_view file(reinterpret_cast<const char*>(data), size);
    // Every other file is the file itself: whatever bytes there are can be a buffer, too.
    const OtherFile others = [&](const std::string& path) {
        if (path.starts_with("no")) throw Failure("there is no such file");
        return file;
    };
    try {
        const SourceMesh mesh = file.starts_with("glTF") ? readGlb(file, others) : readGltf(file, others);
        const std::size_t corners = mesh.corners.size();
        bool isSound = corners > 0 && mesh.faceCount() > 0 && corners % 3 == 0 && mesh.ends.empty();
        isSound &= mesh.normals.size() <= corners && mesh.uvs.size() <= corners && mesh.colours.size() <= corners;
        for (const int vertex : mesh.corners)
            isSound &= vertex >= 0 && static_cast<std::size_t>(vertex) < mesh.vertices.size();
        if (!isSound) __builtin_trap();
    } catch (const Failure&) {
    } catch (const std::bad_alloc&) {
    }
    return 0;
}
