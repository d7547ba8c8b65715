// The files of a mesh: its own, and those that it names.
#pragma once

#include "core/open_below.h"

#include <cstdint>
#include <list>
#include <string>
#include <string_view>

namespace gr::importer {

// A regular file as it is in memory, as long as this is there.
class MappedFile {
public:
    // Throws Failure for what is no regular file. name: as messages call it.
    MappedFile(int descriptor, std::string name);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    const std::string name;
    std::string_view bytes() const { return {data_, size_}; }
    std::int64_t changed() const { return changed_; }  // when, in nanoseconds

private:
    const char* data_ = nullptr;
    std::size_t size_ = 0;
    std::int64_t changed_ = 0;
};

// Files below a folder, each opened once.
class FilesBelow {
public:
    explicit FilesBelow(int folder) : folder_(folder) {}

    // Throws Failure for a path that leads out of the folder, and for one where no regular file is.
    std::string_view bytesOf(const std::string& path);
    const std::list<MappedFile>& opened() const { return opened_; }

private:
    int folder_;
    std::list<MappedFile> opened_;
};

}  // namespace gr::importer
