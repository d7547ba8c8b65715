#include "gr/mesh/mesh_import.h"

#include "core/reader_process.h"

#include <cmath>
#include <filesystem>

namespace gr {

FlatMesh importMesh(const std::string& path, MeshRepairs& repairs, const core::Folder* below) {
    core::ReaderWork work{.program = "grsh_import", .name = "importer", .words = {path}};
    // What importers need grows with the file: 20 times its size is common, and 10 MB a second.
    const double megabytes = std::ceil(static_cast<double>(std::filesystem::file_size(path)) / 1e6);
    work.megabytes = 1000 + 100 * megabytes;
    work.seconds = 10 + megabytes;
    if (below != nullptr) {
        work.words.push_back(below->path);
        work.input = below->descriptor.number();
    }
    core::ReaderProcess import(work);
    import.readOutcome();
    ImportHeader header;
    import.read(&header, sizeof header);
    repairs.linesAndPoints += static_cast<int>(header.linesAndPoints);
    FlatMesh mesh;
    std::vector<core::Vec3f> vertices;
    import.read(vertices, header.vertices);
    mesh.vertices.assign(vertices.begin(), vertices.end());
    import.read(mesh.corners, header.corners);
    import.read(mesh.ends, header.ends);
    import.read(mesh.normals, header.normals);
    return mesh;
}

}  // namespace gr
