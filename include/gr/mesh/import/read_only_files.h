// The files that assimp may see.
#pragma once

#include <assimp/IOSystem.hpp>

#include <string>

namespace gr::importer {

// Regular files as they are in memory. Unless others are allowed it is one file alone: no materials, no pictures.
class ReadOnlyFiles final : public Assimp::IOSystem {
public:
    ReadOnlyFiles(std::string file, bool allowOthers) : file_(std::move(file)), allowOthers_(allowOthers) {}

    bool Exists(const char* file) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

private:
    std::string file_;
    bool allowOthers_;
};

}  // namespace gr::importer
