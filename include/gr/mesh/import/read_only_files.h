// The files that assimp may see.
#pragma once

#include "core/open_below.h"

#include <assimp/IOSystem.hpp>

#include <string>

namespace gr::importer {

// Regular files as they are in memory. Unless others are allowed it is one file alone: no materials, no pictures. Where
// there is a folder, open at core::reader::input, there are none but those below it.
class ReadOnlyFiles final : public Assimp::IOSystem {
public:
    ReadOnlyFiles(std::string file, bool allowOthers, const char* below)
        : file_(std::move(file)), allowOthers_(allowOthers), below_(below) {}

    bool Exists(const char* file) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

private:
    // Closed where it is none of them; its size.
    core::Descriptor openRegular(const char* file, std::size_t& size) const;

    std::string file_;
    bool allowOthers_;
    const char* below_;
};

}  // namespace gr::importer
