// A file that is written beside its place and appears there complete.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

namespace image {

class TemporaryFile {
public:
    // target: where it shall appear. name: what messages call it. Throws core::Error when its folder is not there or
    // takes no new files.
    TemporaryFile(const std::filesystem::path& target, const std::string& name);
    // Removes the file unless it was published.
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    std::FILE* stream() { return stream_; }
    // Puts it in its place, over what was there, whose permissions it takes. When that returns it is on the disk, also
    // if the power fails then. Throws core::Error when not all could be written.
    void publish();

private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path target_;
    std::string name_;
    std::string path_;
    std::FILE* stream_ = nullptr;
    int registered_ = -1;
};

// Removes all that are not published yet. A signal handler may call it, and ends the process then.
void removeTemporaryFiles();
// Removes from a folder those that processes have left which did not come to their end. What a process still writes it
// has locked.
void removeAbandonedFiles(const std::filesystem::path& folder);

}  // namespace image
