// grsh_import: reads a mesh file and writes its faces to gr::importChannel; see include/gr/mesh/mesh_import.h.
#include "gr/mesh/import/confinement.h"
#include "gr/mesh/import/read_only_files.h"
#include "gr/mesh/import/scene_flattener.h"
#include "gr/mesh/mesh_import.h"

#include <assimp/importerdesc.h>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
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

void setLimit(decltype(RLIMIT_AS) resource, rlim_t most) {
    rlimit limit{};
    getrlimit(resource, &limit);
    limit.rlim_cur = std::min(most, limit.rlim_max);
    setrlimit(resource, &limit);
}

void limitResources(rlim_t megabytes, rlim_t seconds) {
    setLimit(RLIMIT_CORE, 0);
    setLimit(RLIMIT_CPU, seconds);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    setLimit(RLIMIT_AS, megabytes << 20);
#else
    (void)megabytes;
#endif
}

// A file is what its ending says: assimp would guess among forty formats.
void keepImportersOf(const std::string& ending, Assimp::Importer& reader) {
    for (std::size_t i = reader.GetImporterCount(); i-- > 0;) {
        const std::string endings = " " + std::string(reader.GetImporterInfo(i)->mFileExtensions) + " ";
        if (endings.find(" " + ending + " ") == std::string::npos) reader.UnregisterLoader(reader.GetImporter(i));
    }
}

void put(const void* data, std::size_t bytes) {
    for (const char* at = static_cast<const char*>(data); bytes > 0;) {
        const ssize_t count = write(gr::importChannel, at, bytes);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) _exit(1);
        at += count;
        bytes -= static_cast<std::size_t>(count);
    }
}

template<class T>
void put(const std::vector<T>& values) {
    put(values.data(), values.size() * sizeof(T));
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
    put(&header, sizeof header);
    put(flat.vertices);
    put(flat.corners);
    put(flat.ends);
    put(flat.normals);
}

void putError(std::string_view reason) {
    const gr::ImportHeader header{.errorLength = static_cast<std::uint32_t>(reason.size())};
    put(&header, sizeof header);
    put(reason.data(), reason.size());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4 && argc != 5) return 2;
    // Nobody waits for what is read here when grsh has ended.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    limitResources(std::strtoul(argv[2], nullptr, 10), std::strtoul(argv[3], nullptr, 10));
    if (argc == 5) gr::importer::confineTo(gr::importFolder);
    try {
        importFile(argv[1], argv[4]);
    } catch (const std::bad_alloc&) {
        putError("it asks for more memory than a file of its size should");
    } catch (const std::exception& error) {
        putError(error.what());
    }
    _exit(0);  // without giving back what is given back anyway
}
