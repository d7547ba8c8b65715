#include "render/accumulate/byte_planes.h"

#include "core/error.h"

#include <zlib.h>

namespace render {

std::string PlanePacker::packed() const {
    constexpr int fastest = 1;
    uLongf size = compressBound(bytes_.size());
    std::string packed(size, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes_.data()),
              bytes_.size(), fastest);
    packed.resize(size);
    return packed;
}

PlaneReader::PlaneReader(std::string_view packed, std::size_t size) : bytes_(size, '\0') {
    if (size == 0) return;
    uLongf found = size;
    const int code = uncompress(reinterpret_cast<Bytef*>(bytes_.data()), &found,
                                reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    if (code != Z_OK || found != size) throw core::Error("STATE", "DAMAGED", "", "it is damaged");
}

std::uint32_t checksum(std::string_view bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace render
