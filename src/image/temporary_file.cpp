#include "image/temporary_file.h"

#include "core/error.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace image {
namespace {

// mkstemp makes files for their owner alone; a picture has the permissions that any new file would have.
void usualPermissions(int descriptor) {
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor, 0666 & ~mask);
}

}  // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& target, const std::string& name)
    : target_(target), name_(name), path_((target.parent_path() / ".grsh-XXXXXX").string()) {
    const int descriptor = mkstemp(path_.data());
    if (descriptor < 0) fail(errno);
    usualPermissions(descriptor);
    stream_ = fdopen(descriptor, "wb");
    if (stream_ != nullptr) return;
    const int error = errno;
    close(descriptor);
    unlink(path_.c_str());
    fail(error);
}

TemporaryFile::~TemporaryFile() {
    if (stream_ != nullptr) std::fclose(stream_);
    if (!path_.empty()) unlink(path_.c_str());
}

void TemporaryFile::publish() {
    // What is still in memory is written by fclose: only then it is known whether the disk had room for it.
    const bool failed = std::ferror(stream_) != 0;
    const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
    if (failed || !closed) fail(errno);
    if (std::rename(path_.c_str(), target_.c_str()) != 0) fail(errno);
    path_.clear();
}

void TemporaryFile::fail(int error) const {
    throw core::Error("FILE", "WRITE", name_, "cannot write \"" + name_ + "\": " + std::strerror(error));
}

}  // namespace image
