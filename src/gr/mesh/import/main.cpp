// grsh_import: reads a mesh file and writes its faces; see include/gr/mesh/mesh_import.h.
#include "core/reader_child.h"
#include "gr/mesh/import/read_only_files.h"
#include "gr/mesh/import/scene_flattener.h"
#include "gr/mesh/mesh_import.h"

#include <assimp/importerdesc.h>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <string_view>

namespace {

using gr::importer::Failure;

// In lower case, without the dot.
std::string endingOf(std::string_view file) {
    std::string ending(file.substr(std::min(file.rfind('.'), file.size() - 1) + 1));
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending;
}

// A file is what its ending says: assimp would guess among forty formats.
void keepImportersOf(const std::string& ending, Assimp::Importer& reader) {
    for (std::size_t i = reader.GetImporterCount(); i-- > 0;) {
        const std::string endings = " " + std::string(reader.GetImporterInfo(i)->mFileExtensions) + " ";
        if (endings.find(" " + ending + " ") == std::string::npos) reader.UnregisterLoader(reader.GetImporter(i));
    }
}

// assimp drops faces of glTF files that name vertices which are not there, and only its log tells.
class BadIndexStream final : public Assimp::LogStream {
public:
    void write(const char* message) override { isSeen |= std::strstr(message, "out-of-range") != nullptr; }

    bool isSeen = false;
};

// What assimp says of a failure, as the end of a sentence.
std::string reasonOf(std::string text, const std::string& ending) {
    if (text.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    if (text.starts_with("No suitable reader")) return "it is not a whole ." + ending + " file";
    while (!text.empty() && (text.back() == '.' || std::isspace(static_cast<unsigned char>(text.back()))))
        text.pop_back();
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
    constexpr std::size_t most = 200;
    if (text.size() > most) text = text.substr(0, most) + "...";
    return text.empty() ? "the importer does not tell why" : text;
}

// below: the folder that all files lie below, or null.
void importFile(const std::string& file, const char* below) {
    const std::string ending = endingOf(file);
    const bool isGltf = ending == "gltf" || ending == "glb";
    // Never freed: the process ends first.
    Assimp::Importer& reader = *new Assimp::Importer;
    keepImportersOf(ending, reader);
    reader.SetIOHandler(new gr::importer::ReadOnlyFiles(file, isGltf, below));
    // No step of assimp's own behind it: they merge, drop, turn or move what is to stay as it is.
    BadIndexStream badIndices;
    if (isGltf) Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0)->attachStream(&badIndices);
    const aiScene* scene = reader.ReadFile(file, 0);
    if (scene == nullptr) throw Failure(reasonOf(reader.GetErrorString(), ending));
    if (badIndices.isSeen) throw Failure("a face names a vertex that is not there");
    // An STL file has the faces' own normals only.
    const gr::importer::SceneFlattener flat(*scene, ending != "stl");
    const auto size = [](const auto& values) { return static_cast<std::uint32_t>(values.size()); };
    const gr::ImportHeader header{.vertices = size(flat.vertices),
                                  .corners = size(flat.corners),
                                  .ends = size(flat.ends),
                                  .normals = size(flat.normals),
                                  .linesAndPoints = flat.linesAndPoints};
    core::reader::putSuccess();
    core::reader::put(&header, sizeof header);
    core::reader::put(flat.vertices);
    core::reader::put(flat.corners);
    core::reader::put(flat.ends);
    core::reader::put(flat.normals);
}

}  // namespace

int main(int argc, char** argv) {
    namespace reader = core::reader;
    // A file, and the folder that files must lie below, which is open at reader::input.
    const int words = argc - reader::firstWord;
    if (words != 1 && words != 2) return 2;
    const char* const below = words == 2 ? argv[reader::firstWord + 1] : nullptr;
    reader::begin(argv);
    if (below != nullptr) reader::confineTo(reader::input);
    try {
        importFile(argv[reader::firstWord], below);
    } catch (const std::bad_alloc&) {
        reader::putError("it asks for more memory than a file of its size should");
    } catch (const std::exception& error) {
        reader::putError(error.what());
    }
    _exit(0);  // without giving back what is given back anyway
}
