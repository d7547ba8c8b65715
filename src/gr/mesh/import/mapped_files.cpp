#include "gr/mesh/import/mapped_files.h"

#include "gr/mesh/import/source_mesh.h"

#include <sys/mman.h>
#include <sys/stat.h>

#include <cctype>
#include <cerrno>
#include <cstring>

namespace gr::importer {

MappedFile::MappedFile(int descriptor, std::string name) : name(std::move(name)) {
    struct stat status;
    if (fstat(descriptor, &status) != 0) throw Failure(std::strerror(errno));
    if (!S_ISREG(status.st_mode)) throw Failure("\"" + this->name + "\" is not a regular file");
    size_ = static_cast<std::size_t>(status.st_size);
    changed_ = status.st_mtim.tv_sec * 1000000000 + status.st_mtim.tv_nsec;
    if (size_ == 0) return;
    void* data = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
    if (data == MAP_FAILED) throw Failure(std::strerror(errno));
    data_ = static_cast<const char*>(data);
}

MappedFile::~MappedFile() {
    if (size_ > 0) munmap(const_cast<char*>(data_), size_);
}

std::string_view FilesBelow::bytesOf(const std::string& path) {
    for (const MappedFile& file : opened_)
        if (file.name == path) return file.bytes();
    const core::Descriptor descriptor = core::openFileBelow(folder_, path);
    if (!descriptor.isOpen()) {
        const bool leadsOut = errno == EXDEV || errno == ELOOP;
        std::string reason = std::strerror(errno);
        reason[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(reason[0])));
        throw Failure("the file \"" + path + "\" " +
                      (leadsOut ? "leads out of the mesh's own folder" : "cannot be read: " + reason));
    }
    return opened_.emplace_back(descriptor.number(), path).bytes();
}

}  // namespace gr::importer
