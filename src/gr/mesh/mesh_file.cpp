#include "gr/mesh/mesh_file.h"

#include "core/allocated.h"
#include "core/error.h"
#include "gr/mesh/mesh_formats.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace gr {
namespace {

[[noreturn]] void fail(std::string reason) {
    reason[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(reason[0])));
    throw core::Error("MESH", "FILE", "", reason);
}

// In lower case.
std::string endingOf(const std::string& path) {
    std::string ending = path.substr(std::min(path.rfind('.'), path.size()));
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (std::find(meshEndings.begin(), meshEndings.end(), ending) == meshEndings.end())
        fail("the name of a mesh file ends in " + core::listed(meshEndings));
    return ending;
}

std::string reasonOf(int error) {
    if (error == EXDEV) return "a link leads to another folder";
    return error == EINVAL ? "it is not a regular file" : std::strerror(error);
}

core::Descriptor openMesh(const std::string& path, const core::Folder* below) {
    if (below == nullptr) return core::Descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    const std::optional<std::string> rest = core::pathBelow(below->path, path);
    if (rest) return core::openFileBelow(below->descriptor.number(), *rest);
    errno = EXDEV;
    return core::Descriptor();
}

// The folder that a file lies in.
core::Descriptor openFolder(const std::string& path, const core::Folder* below) {
    constexpr int flags = O_PATH | O_DIRECTORY | O_CLOEXEC;
    const std::string folder = std::filesystem::path(path).parent_path();
    if (below == nullptr) return core::Descriptor(open(folder.empty() ? "." : folder.c_str(), flags));
    return core::openBelow(below->descriptor.number(), core::pathBelow(below->path, folder).value_or("."), flags);
}

struct OpenMesh {
    OpenMesh(const std::string& path, const core::Folder* below)
        : file(openMesh(path, below)), folder(openFolder(path, below)) {
        if (!file.isOpen() || fstat(file.number(), &status) != 0) fail(reasonOf(errno));
        if (S_ISDIR(status.st_mode)) fail(std::strerror(EISDIR));
        if (!S_ISREG(status.st_mode)) fail("it is not a regular file");
        if (status.st_size == 0) fail("it is empty");
        if (!folder.isOpen()) fail("its folder cannot be opened");
    }

    core::Descriptor file, folder;
    struct stat status;
};

std::int64_t changeOf(const struct stat& status) {
    return status.st_mtim.tv_sec * 1000000000 + status.st_mtim.tv_nsec;
}

bool areUnchanged(const std::vector<NamedFile>& files, int folder) {
    return std::all_of(files.begin(), files.end(), [&](const NamedFile& file) {
        struct stat status;
        return fstatat(folder, file.path.c_str(), &status, 0) == 0 && status.st_size == file.size &&
               changeOf(status) == file.changed;
    });
}

std::string withoutLinks(const std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> real(realpath(path.c_str(), nullptr), &std::free);
    return real ? real.get() : path;
}

constexpr std::array<core::OptionRow<MeshSettings>, 1> rows{{
    {.name = "smooth",
     .member = &MeshSettings::smooth,
     .range = {.least = 0, .most = 180},
     .unit = "degrees",
     .help = "where the file has no normals, edges flatter than this are rounded for shading"},
}};

}  // namespace

std::span<const core::OptionRow<MeshSettings>> MeshSettings::options() {
    return rows;
}

std::shared_ptr<const Polyhedron> MeshFiles::read(const std::string& path, std::string_view name, MeshRepairs& repairs,
                                                  const core::Folder* below, const MeshSettings& settings) {
    try {
        const std::string ending = endingOf(path);
        const OpenMesh open(path, below);
        Entry& entry = entries_[core::numberText(settings.smooth) + ' ' + withoutLinks(path)];
        std::shared_ptr<const Polyhedron> polyhedron = entry.polyhedron.lock();
        const bool isSame = entry.size == open.status.st_size && entry.changed == changeOf(open.status) &&
                            areUnchanged(entry.named, open.folder.number());
        if (polyhedron != nullptr && isSame) return polyhedron;
        ImportedMesh imported = importMesh(open.file.number(), ending, open.folder.number(), repairs);
        polyhedron = Polyhedron::make(std::move(imported.mesh), repairs, settings.smooth);
        entry = {polyhedron, open.status.st_size, changeOf(open.status), std::move(imported.files)};
        return polyhedron;
    } catch (const core::Error& error) {
        throw core::Error("MESH", "FILE", path, "cannot read \"" + std::string(name) + "\": " + error.what());
    }
}

std::size_t MeshFiles::bytes() const {
    std::size_t bytes = core::allocatedByTable(entries_);
    for (const auto& [path, entry] : entries_) {
        bytes += core::allocatedBytes(path) + entry.named.capacity() * sizeof(NamedFile);
        for (const NamedFile& file : entry.named) bytes += core::allocatedBytes(file.path);
    }
    return bytes;
}

}  // namespace gr
