#include "image/temporary_file.h"

#include "core/error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <string_view>

namespace image {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".grsh-";
constexpr std::size_t nameLength = prefix.size() + 6;

// Absolute paths of the files that are there now, where a signal handler can read them.
struct Entry {
    std::atomic<bool> isTaken = false;
    std::atomic<bool> isThere = false;
    char path[PATH_MAX];
};
std::array<Entry, 16> entries;

int registered(const std::string& path) {
    std::error_code failed;
    const std::string absolute = fs::absolute(path, failed).string();
    if (failed || absolute.size() >= PATH_MAX) return -1;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i].isTaken.exchange(true)) continue;
        std::memcpy(entries[i].path, absolute.c_str(), absolute.size() + 1);
        entries[i].isThere = true;
        return static_cast<int>(i);
    }
    return -1;
}

void forget(int entry) {
    if (entry < 0) return;
    entries[static_cast<std::size_t>(entry)].isThere = false;
    entries[static_cast<std::size_t>(entry)].isTaken = false;
}

// mkstemp makes files for their owner alone; a picture has the permissions of the one whose place it takes, or those
// that any new file would have.
void setPermissions(int descriptor, const fs::path& target) {
    struct stat there;
    mode_t mode = 0;
    if (stat(target.c_str(), &there) == 0) {
        mode = there.st_mode & 07777;
    } else {
        const mode_t mask = umask(0);
        umask(mask);
        mode = 0666 & ~mask;
    }
    fchmod(descriptor, mode);
}

// A file of its own, locked for as long as it is open. One that another process has taken for abandoned before it was
// locked has no name any more, and is made anew.
int makeLocked(std::string& path) {
    const std::string pattern = path;
    while (true) {
        path = pattern;
        const int descriptor = mkostemp(path.data(), O_CLOEXEC);
        if (descriptor < 0) return -1;
        flock(descriptor, LOCK_EX | LOCK_NB);
        struct stat status;
        if (fstat(descriptor, &status) != 0 || status.st_nlink > 0) return descriptor;
        close(descriptor);
    }
}

// Also true of what has no disk.
bool isOnDisk(int descriptor) {
    return fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
}

// A name is on the disk once its folder is.
void syncFolder(const fs::path& target) {
    const fs::path folder = target.parent_path().empty() ? "." : target.parent_path();
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& target, const std::string& name)
    : target_(target), name_(name), path_((target.parent_path() / (std::string(prefix) + "XXXXXX")).string()) {
    const int descriptor = makeLocked(path_);
    if (descriptor < 0) fail(errno);
    registered_ = registered(path_);
    setPermissions(descriptor, target);
    stream_ = fdopen(descriptor, "wb");
    if (stream_ != nullptr) return;
    const int error = errno;
    close(descriptor);
    unlink(path_.c_str());
    forget(registered_);
    fail(error);
}

TemporaryFile::~TemporaryFile() {
    if (!path_.empty()) unlink(path_.c_str());
    if (stream_ != nullptr) std::fclose(stream_);
    forget(registered_);
}

void TemporaryFile::publish() {
    // Only once it is on the disk it is known whether there was room for it. It is locked until it has its name.
    errno = 0;
    const bool isWritten = std::fflush(stream_) == 0 && std::ferror(stream_) == 0 && isOnDisk(fileno(stream_));
    if (!isWritten) fail(errno != 0 ? errno : ENOSPC);
    if (std::rename(path_.c_str(), target_.c_str()) != 0) fail(errno);
    path_.clear();
    syncFolder(target_);
}

void TemporaryFile::fail(int error) const {
    throw core::Error("FILE", "WRITE", name_, "cannot write \"" + name_ + "\": " + std::strerror(error));
}

void removeTemporaryFiles() {
    for (const Entry& entry : entries)
        if (entry.isThere) unlink(entry.path);
}

void removeAbandonedFiles(const fs::path& folder) {
    std::error_code failed;
    for (fs::directory_iterator it(folder.empty() ? "." : folder, failed), end; !failed && it != end;
         it.increment(failed)) {
        const std::string name = it->path().filename().string();
        if (!name.starts_with(prefix) || name.size() != nameLength) continue;
        const int descriptor = open(it->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0) continue;
        struct stat status;
        const bool isFile = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
        if (isFile && flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(it->path().c_str());
        close(descriptor);
    }
}

}  // namespace image
