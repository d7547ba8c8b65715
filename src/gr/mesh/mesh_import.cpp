#include "gr/mesh/mesh_import.h"

#include "core/reader_process.h"

#include <sys/stat.h>

#include <cmath>

namespace gr {
namespace {

// Takes the first text from a list in which a zero is behind each.
std::string takeText(std::string_view& texts) {
    const std::string text(texts.substr(0, texts.find('\0')));
    texts.remove_prefix(std::min(text.size() + 1, texts.size()));
    return text;
}

std::string readTexts(core::ReaderProcess& import, std::size_t size) {
    std::string texts(size, '\0');
    import.read(texts.data(), texts.size());
    return texts;
}

// groups: where each begins. Says of each face which one it is in.
void readGroups(core::ReaderProcess& import, const ImportHeader& header, FlatMesh& mesh) {
    std::vector<std::int64_t> begins;
    import.read(begins, header.groups);
    const std::string all = readTexts(import, header.groupTexts);
    std::string_view texts = all;
    mesh.groupOf.reserve(begins.empty() ? 0 : static_cast<std::size_t>(mesh.faceCount()));
    for (std::size_t i = 0; i < begins.size(); ++i) {
        const std::int64_t end = i + 1 < begins.size() ? begins[i + 1] : mesh.faceCount();
        mesh.groupOf.resize(static_cast<std::size_t>(end), static_cast<std::uint32_t>(i));
        std::string name = takeText(texts);
        mesh.groups.push_back({std::move(name), takeText(texts)});
    }
}

std::vector<NamedFile> readFiles(core::ReaderProcess& import, const ImportHeader& header) {
    std::vector<std::int64_t> numbers;
    import.read(numbers, 2 * std::size_t(header.files));
    const std::string all = readTexts(import, header.fileTexts);
    std::string_view texts = all;
    std::vector<NamedFile> files;
    for (std::size_t i = 0; i < numbers.size(); i += 2) files.push_back({takeText(texts), numbers[i], numbers[i + 1]});
    return files;
}

}  // namespace

ImportedMesh importMesh(int file, const std::string& ending, int folder, MeshRepairs& repairs) {
    struct stat status = {};
    fstat(file, &status);
    // What readers need grows with the file: 20 times its size is common, and 10 MB a second.
    const double megabytes = std::ceil(static_cast<double>(status.st_size) / 1e6);
    core::ReaderProcess import({.program = "grsh_import",
                                .name = "importer",
                                .words = {ending},
                                .inputs = {file, folder},
                                .megabytes = 1000 + 100 * megabytes,
                                .seconds = 10 + megabytes});
    import.readOutcome();
    ImportHeader header;
    import.read(&header, sizeof header);
    repairs.linesAndPoints += static_cast<int>(header.linesAndPoints);
    repairs.absentReferences += static_cast<int>(header.absentReferences);

    ImportedMesh imported;
    FlatMesh& mesh = imported.mesh;
    std::vector<core::Vec3f> vertices;
    import.read(vertices, header.vertices);
    mesh.vertices.reserve(vertices.size());
    for (const core::Vec3f& vertex : vertices) mesh.vertices.push_back(header.origin + glm::dvec3(vertex));
    import.read(mesh.corners, header.corners);
    import.read(mesh.ends, header.ends);
    import.read(mesh.normals, header.normals);
    import.read(mesh.uvs, header.uvs);
    import.read(mesh.colours, header.colours);
    readGroups(import, header, mesh);
    imported.files = readFiles(import, header);
    return imported;
}

}  // namespace gr
