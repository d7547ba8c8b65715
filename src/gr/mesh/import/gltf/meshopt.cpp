#include "gr/mesh/import/gltf/meshopt.h"

#include "gr/mesh/import/gltf/words.h"

#include <meshoptimizer.h>

namespace gr::importer {
namespace {

[[noreturn]] void failUnpack(const JsonObject& extension) {
    throw Failure(extension.subject() + " is not what meshoptimizer packs");
}

// What the library's functions take for granted.
void checkStride(const JsonObject& extension, const std::string& mode, std::uint64_t stride) {
    const bool isFit =
        mode == "ATTRIBUTES" ? stride % 4 == 0 && stride >= 4 && stride <= 256 : stride == 2 || stride == 4;
    if (!isFit)
        throw Failure(extension.subjectOf("byteStride") + " is " + std::to_string(stride) + ", which " +
                      inQuotes(mode) + " cannot have");
}

// The most bytes that a packed one can become. Packed vertices have two bits for each 16 bytes at least, packed
// triangles one byte for each three indices, packed indices one byte for each.
std::uint64_t mostGrowth(const std::string& mode, std::uint64_t stride) {
    if (mode == "ATTRIBUTES") return 64;
    return mode == "TRIANGLES" ? 3 * stride : stride;
}

using Decode = int (*)(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);

Decode decoderOf(const JsonObject& extension, const std::string& mode) {
    if (mode == "ATTRIBUTES") return meshopt_decodeVertexBuffer;
    if (mode == "TRIANGLES") return meshopt_decodeIndexBuffer;
    if (mode == "INDICES") return meshopt_decodeIndexSequence;
    throw Failure(extension.subjectOf("mode") + " is " + inQuotes(mode) +
                  " instead of \"ATTRIBUTES\", \"TRIANGLES\" or " + "\"INDICES\"");
}

void applyFilter(const JsonObject& extension, std::string& bytes, std::size_t count, std::size_t stride) {
    const std::string filter = extension.text("filter");
    if (filter.empty() || filter == "NONE") return;
    const bool isFit = filter == "OCTAHEDRAL" ? stride == 4 || stride == 8 : filter != "QUATERNION" || stride == 8;
    if (!isFit || extension.text("mode") != "ATTRIBUTES")
        throw Failure(extension.subjectOf("filter") + " is " + inQuotes(filter) +
                      ", which does not go with its stride " + "or mode");
    if (filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(bytes.data(), count, stride);
    else if (filter == "QUATERNION")
        meshopt_decodeFilterQuat(bytes.data(), count, stride);
    else if (filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(bytes.data(), count, stride);
    else
        throw Failure(extension.subjectOf("filter") + " is " + inQuotes(filter) + ", which is not known");
}

}  // namespace

std::string unpackMeshopt(const JsonObject& extension, std::string_view packed) {
    const std::string mode = extension.text("mode");
    const std::uint64_t stride = extension.neededWhole("byteStride"), count = extension.neededWhole("count");
    const Decode decode = decoderOf(extension, mode);
    checkStride(extension, mode, stride);
    if (mode == "TRIANGLES" && count % 3 != 0)
        throw Failure(extension.subjectOf("count") + " is " + std::to_string(count) + ", which makes no triangles");
    if (count > packed.size() * mostGrowth(mode, stride) / stride) failUnpack(extension);
    std::string bytes(count * stride, '\0');
    if (count == 0) return bytes;
    if (decode(bytes.data(), count, stride, reinterpret_cast<const unsigned char*>(packed.data()), packed.size()) != 0)
        failUnpack(extension);
    applyFilter(extension, bytes, count, stride);
    return bytes;
}

}  // namespace gr::importer
