#include "gr/mesh/import/read_only_files.h"

#include "core/reader_child.h"

#include <assimp/IOStream.hpp>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

namespace gr::importer {
namespace {

class MappedFile final : public Assimp::IOStream {
public:
    MappedFile(const char* data, std::size_t size) : data_(data), size_(size) {}
    ~MappedFile() override {
        if (size_ > 0) munmap(const_cast<char*>(data_), size_);
    }

    std::size_t Read(void* to, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        const std::size_t whole = std::min(count, (size_ - at_) / size);
        if (whole > 0) std::memcpy(to, data_ + at_, whole * size);
        at_ += whole * size;
        return whole;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const std::size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : size_;
        const std::size_t to = from + offset;  // wraps round for an offset backwards
        if (to > size_) return aiReturn_FAILURE;
        at_ = to;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return at_; }
    std::size_t FileSize() const override { return size_; }
    void Flush() override {}

private:
    const char* data_;
    std::size_t size_;
    std::size_t at_ = 0;
};

core::Descriptor openBelow(const char* folder, const char* file) {
    const std::optional<std::string> rest = core::pathBelow(folder, file);
    return rest ? core::openFileBelow(core::reader::input, *rest) : core::Descriptor();
}

}  // namespace

core::Descriptor ReadOnlyFiles::openRegular(const char* file, std::size_t& size) const {
    if (!allowOthers_ && file != file_) return core::Descriptor();
    core::Descriptor opened =
        below_ != nullptr ? openBelow(below_, file) : core::Descriptor(open(file, O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status;
    if (!opened.isOpen() || fstat(opened.number(), &status) != 0 || !S_ISREG(status.st_mode)) return core::Descriptor();
    size = static_cast<std::size_t>(status.st_size);
    return opened;
}

bool ReadOnlyFiles::Exists(const char* file) const {
    std::size_t size = 0;
    return openRegular(file, size).isOpen();
}

Assimp::IOStream* ReadOnlyFiles::Open(const char* file, const char*) {
    std::size_t size = 0;
    const core::Descriptor opened = openRegular(file, size);
    if (!opened.isOpen()) return nullptr;
    void* data = size > 0 ? mmap(nullptr, size, PROT_READ, MAP_PRIVATE, opened.number(), 0) : nullptr;
    return data == MAP_FAILED ? nullptr : new MappedFile(static_cast<const char*>(data), size);
}

void ReadOnlyFiles::Close(Assimp::IOStream* stream) {
    delete stream;
}

}  // namespace gr::importer
