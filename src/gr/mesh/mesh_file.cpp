#include "gr/mesh/mesh_file.h"

#include "core/allocated.h"
#include "core/error.h"
#include "gr/mesh/mesh_import.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace gr {
namespace {

[[noreturn]] void fail(std::string reason) {
    reason[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(reason[0])));
    throw core::Error("MESH", "FILE", "", reason);
}

// In lower case.
std::string endingOf(const std::string& path) {
    constexpr std::array<std::string_view, 5> known{".obj", ".ply", ".stl", ".gltf", ".glb"};
    std::string ending = path.substr(std::min(path.rfind('.'), path.size()));
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (std::find(known.begin(), known.end(), ending) == known.end())
        fail("the name of a mesh file ends in " + core::listed(known));
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

struct OpenFile {
    OpenFile(const std::string& path, const core::Folder* below) : descriptor(openMesh(path, below)) {
        if (!descriptor.isOpen() || fstat(descriptor.number(), &status) != 0) fail(reasonOf(errno));
    }

    core::Descriptor descriptor;
    struct stat status;
};

void checkContents(const OpenFile& file, std::string_view ending) {
    if (S_ISDIR(file.status.st_mode)) fail(std::strerror(EISDIR));
    if (!S_ISREG(file.status.st_mode)) fail("it is not a regular file");
    if (file.status.st_size == 0) fail("it is empty");
    const auto size = static_cast<std::size_t>(file.status.st_size);
    void* data = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.descriptor.number(), 0);
    if (data == MAP_FAILED) fail(std::strerror(errno));
    const auto unmap = [size](void* mapped) { munmap(mapped, size); };
    const std::unique_ptr<void, decltype(unmap)> mapping(data, unmap);
    checkAnnounced({static_cast<const char*>(data), size}, ending);
}

std::string withoutLinks(const std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> real(realpath(path.c_str(), nullptr), &std::free);
    return real ? real.get() : path;
}

std::shared_ptr<const Polyhedron> readMesh(const OpenFile& file, const std::string& path, MeshRepairs& repairs,
                                           const core::Folder* below) {
    checkContents(file, endingOf(path));
    return Polyhedron::make(importMesh(path, repairs, below), repairs);
}

}  // namespace

std::shared_ptr<const Polyhedron> MeshFiles::read(const std::string& path, std::string_view name, MeshRepairs& repairs,
                                                  const core::Folder* below) {
    try {
        endingOf(path);
        const OpenFile file(path, below);
        const auto size = static_cast<std::uintmax_t>(file.status.st_size);
        const std::int64_t changed = file.status.st_mtim.tv_sec * 1000000000 + file.status.st_mtim.tv_nsec;
        Entry& entry = entries_[withoutLinks(path)];
        std::shared_ptr<const Polyhedron> polyhedron = entry.polyhedron.lock();
        if (polyhedron != nullptr && entry.size == size && entry.changed == changed) return polyhedron;
        polyhedron = readMesh(file, path, repairs, below);
        entry = {polyhedron, size, changed};
        return polyhedron;
    } catch (const core::Error& error) {
        throw core::Error("MESH", "FILE", path, "cannot read \"" + std::string(name) + "\": " + error.what());
    }
}

std::size_t MeshFiles::bytes() const {
    std::size_t bytes = core::allocatedByTable(entries_);
    for (const auto& [path, entry] : entries_) bytes += core::allocatedBytes(path);
    return bytes;
}

}  // namespace gr
