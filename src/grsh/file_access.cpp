#include "grsh/file_access.h"

#include "core/error.h"
#include "image/image_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace grsh {
namespace fs = std::filesystem;

namespace {

using core::Descriptor;

[[noreturn]] void fail(const char* verb, const std::string& name, const std::string& why) {
    const bool reads = std::strcmp(verb, "read") == 0;
    throw core::Error("FILE", reads ? "READ" : "WRITE", name,
                      std::string("cannot ") + verb + " \"" + name + "\": " + why);
}

// --safe reads only below "/a" or "/b"
template<class Roots>
std::string only(const char* verb, const Roots& roots) {
    std::vector<std::string> quoted;
    for (const auto& root : roots) quoted.push_back("\"" + root.folder.path + "\"");
    const std::vector<std::string_view> names(quoted.begin(), quoted.end());
    return std::string("--safe ") + verb + "s only below " + core::listed(names);
}

// Calls open(folder, rest) for each folder that the path lies below, until one is open. errno tells why none is.
template<class Roots, class Open>
Descriptor openInAny(const Roots& roots, const std::string& path, const Open& open) {
    int error = EXDEV;
    for (const auto& root : roots) {
        std::optional<std::string> rest = core::pathBelow(root.folder.path, path);
        if (!rest) rest = core::pathBelow(root.given, path);
        if (!rest) continue;
        Descriptor opened = open(root.folder.descriptor.number(), *rest);
        if (opened.isOpen()) return opened;
        error = errno;
    }
    errno = error;
    return Descriptor();
}

std::string reasonOf(int error, const std::string& notAllowed) {
    if (error == EXDEV || error == ELOOP) return notAllowed;
    return error == EINVAL ? "it is not a regular file" : std::strerror(error);
}

}  // namespace

std::string plainPath(const std::string& name) {
    std::string path = (fs::current_path() / name).lexically_normal().string();
    while (path.size() > 1 && path.ends_with('/')) path.pop_back();
    return path;
}

FileAccess::FileAccess(const std::vector<std::string>& reads, const std::vector<std::string>& writes)
    : isSafe_(true), reads_(openRoots("read", reads)), writes_(openRoots("write", writes)) {}

FileAccess::Roots FileAccess::openRoots(const char* verb, const std::vector<std::string>& folders) {
    Roots roots;
    for (const std::string& given : folders) {
        Descriptor descriptor(::open(given.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
        if (!descriptor.isOpen()) fail(verb, given, std::strerror(errno));
        std::error_code failed;
        const std::string path = fs::read_symlink(descriptor.path(), failed).string();
        if (failed) fail(verb, given, failed.message());
        roots.push_back({{std::move(descriptor), path}, plainPath(given)});
    }
    return roots;
}

image::FileName FileAccess::openFile(const std::string& path, const std::string& name, const Roots& roots) const {
    Descriptor file = openInAny(roots, plainPath(path), core::openFileBelow);
    if (!file.isOpen()) fail("read", name, reasonOf(errno, only("read", roots)));
    const std::string opened = file.path();
    return {name, opened, std::move(file)};
}

image::FileName FileAccess::toRead(const std::string& name) const {
    return toRead(name, name);
}

image::FileName FileAccess::toRead(const std::string& path, const std::string& name) const {
    if (isSafe_) return openFile(path, name, reads_);
    image::FileName file(path);
    file.name = name;
    return file;
}

image::FileName FileAccess::toReadBack(const std::string& name) const {
    return isSafe_ ? openFile(name, name, writes_) : image::FileName(name);
}

image::FileName FileAccess::toWrite(const std::string& name) const {
    if (!isSafe_) return name;
    const std::string path = plainPath(name);
    const std::string folder = path.substr(0, std::max<std::size_t>(path.rfind('/'), 1));
    const std::string file = path.substr(path.rfind('/') + 1);
    if (name.empty() || name.ends_with('/') || file.empty()) fail("write", name, "it is not a file");
    Descriptor opened = openInAny(writes_, folder, [](int below, const std::string& rest) {
        return core::openBelow(below, rest, O_PATH | O_DIRECTORY);
    });
    if (!opened.isOpen()) fail("write", name, reasonOf(errno, only("write", writes_)));
    struct stat status;
    if (fstatat(opened.number(), file.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISREG(status.st_mode))
        fail("write", name, S_ISLNK(status.st_mode) ? "--safe does not write where a link leads" : "it is not a file");
    const std::string place = opened.path() + "/" + file;
    return {name, place, std::move(opened)};
}

const core::Folder* FileAccess::folderToRead(const std::string& path, const std::string& name) const {
    if (!isSafe_) return nullptr;
    for (const Root& root : reads_)
        if (core::pathBelow(root.folder.path, path)) return &root.folder;
    fail("read", name, only("read", reads_));
}

Descriptor FileAccess::openForTcl(const std::string& name, int flags) const {
    const std::string path = plainPath(name);
    for (const std::string& file : tclFiles_)
        if (core::pathBelow(file, path)) return Descriptor(::open(path.c_str(), flags | O_CLOEXEC));
    // An encoding is Tcl's own, whose reader trusts it.
    if (path.ends_with(".enc")) {
        errno = EXDEV;
        return Descriptor();
    }
    return openInAny(reads_, path, [&](int below, const std::string& rest) {
        if (flags & O_PATH) return core::openBelow(below, rest, flags);
        return core::openFileBelow(below, rest);
    });
}

void FileAccess::letTclRead(const std::string& path) {
    tclFiles_.push_back(path);
}

}  // namespace grsh
