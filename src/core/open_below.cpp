#include "core/open_below.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>

namespace core {
namespace {

int openat2(int folder, const std::string& path, int flags) {
    open_how how = {};
    how.flags = static_cast<std::uint64_t>(flags);
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
    return static_cast<int>(syscall(SYS_openat2, folder, path.c_str(), &how, sizeof how));
}

// Names between slashes, "." left out.
std::string nextName(std::string_view& path) {
    while (!path.empty()) {
        const std::size_t end = std::min(path.find('/'), path.size());
        const std::string name(path.substr(0, end));
        path.remove_prefix(std::min(end + 1, path.size()));
        if (!name.empty() && name != ".") return name;
    }
    return "";
}

Descriptor failed(int error) {
    errno = error;
    return Descriptor();
}

}  // namespace

void Descriptor::close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
}

std::optional<std::string> pathBelow(std::string_view folder, std::string_view path) {
    if (path == folder) return ".";
    if (!folder.ends_with('/')) {
        if (!path.starts_with(folder) || path.substr(folder.size(), 1) != "/") return std::nullopt;
        return std::string(path.substr(folder.size() + 1));
    }
    return path.starts_with(folder) ? std::optional(std::string(path.substr(folder.size()))) : std::nullopt;
}

Descriptor openBelow(int folder, const std::string& path, int flags) {
    constexpr int kTries = 20;  // somebody may rename folders on the way
    if (path.find('\0') != path.npos) return failed(EINVAL);
    int descriptor = -1;
    for (int i = 0; i < kTries; ++i) {
        descriptor = openat2(folder, path, flags | O_CLOEXEC);
        if (descriptor >= 0 || errno != EAGAIN) break;
    }
    if (descriptor >= 0 || (errno != ENOSYS && errno != EPERM)) return Descriptor(descriptor);
    return openBelowByWalking(folder, path, flags);
}

Descriptor openBelowByWalking(int folder, const std::string& path, int flags) {
    if (path.starts_with('/') || path.find('\0') != path.npos) return failed(EXDEV);
    constexpr int kWalk = O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
    Descriptor at(openat(folder, ".", kWalk));
    std::string_view rest = path;
    std::string name = nextName(rest);
    while (at.isOpen() && !name.empty()) {
        const std::string next = nextName(rest);
        if (name == "..") return failed(EXDEV);
        struct stat status;
        if (fstatat(at.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(status.st_mode))
            return failed(EXDEV);
        if (next.empty()) return Descriptor(openat(at.number(), name.c_str(), flags | O_NOFOLLOW | O_CLOEXEC));
        at = Descriptor(openat(at.number(), name.c_str(), kWalk));
        name = next;
    }
    return at.isOpen() ? Descriptor(openat(at.number(), ".", flags | O_CLOEXEC)) : Descriptor();
}

Descriptor openFileBelow(int folder, const std::string& path) {
    Descriptor file = openBelow(folder, path, O_RDONLY | O_NONBLOCK | O_NOCTTY);
    struct stat status;
    if (!file.isOpen() || fstat(file.number(), &status) != 0) return file;
    if (S_ISREG(status.st_mode)) return file;
    return failed(S_ISDIR(status.st_mode) ? EISDIR : EINVAL);
}

}  // namespace core
