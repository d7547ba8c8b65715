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
    // Puts it in its place, over what was there. Throws core::Error when not all could be written.
    void publish();

private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path target_;
    std::string name_;
    std::string path_;
    std::FILE* stream_ = nullptr;
};

}  // namespace image
