#include "gr/mesh/import/gltf/glb.h"

#include "gr/mesh/import/source_mesh.h"

#include <cstring>

namespace gr::importer {
namespace {

constexpr std::size_t headerSize = 12, chunkHeaderSize = 8;

std::uint32_t numberAt(std::string_view file, std::size_t offset) {
    std::uint32_t number;
    std::memcpy(&number, file.data() + offset, sizeof number);
    return number;
}

void checkHeader(std::string_view file) {
    if (!file.starts_with("glTF")) throw Failure("it does not begin with \"glTF\", as a .glb file does");
    if (file.size() < headerSize + chunkHeaderSize)
        throw Failure("it ends within its header, after " + std::to_string(file.size()) + " bytes");
    const std::uint32_t version = numberAt(file, 4), length = numberAt(file, 8);
    if (version != 2) throw Failure("it is glTF " + std::to_string(version) + ", and only glTF 2 is read");
    if (length > file.size())
        throw Failure("it has " + std::to_string(file.size()) + " bytes, but its header tells of " +
                      std::to_string(length));
}

struct Chunk {
    std::string_view type, bytes;
    std::size_t end = 0;
};

std::optional<Chunk> chunkAt(std::string_view file, std::size_t offset) {
    if (offset + chunkHeaderSize > file.size()) return {};
    const std::size_t length = numberAt(file, offset), begin = offset + chunkHeaderSize;
    if (length > file.size() - begin) return {};
    return Chunk{file.substr(offset + 4, 4), file.substr(begin, length), begin + length};
}

}  // namespace

GlbParts partsOfGlb(std::string_view file) {
    checkHeader(file);
    const std::optional<Chunk> json = chunkAt(file, headerSize);
    if (!json) throw Failure("it ends within its JSON part");
    if (json->type != "JSON") throw Failure("its first part is not its JSON");
    GlbParts parts{json->bytes, {}};
    // The next part begins at a multiple of four bytes; some programs forget to see to that, or to count what they fill
    // in for it.
    const std::size_t aligned = (json->end + 3) / 4 * 4;
    constexpr std::string_view binaryType("BIN\0", 4);
    for (const std::size_t offset : {json->end, aligned}) {
        const bool isHere = offset + chunkHeaderSize <= file.size() && file.substr(offset + 4, 4) == binaryType;
        if (!isHere) continue;
        const std::optional<Chunk> binary = chunkAt(file, offset);
        if (!binary) throw Failure("it ends within its binary part");
        parts.binary = binary->bytes;
        break;
    }
    return parts;
}

}  // namespace gr::importer
