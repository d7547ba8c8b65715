// The bytes of a glTF file.
#pragma once

#include "gr/mesh/import/gltf/document.h"
#include "gr/mesh/import/readers.h"

#include <deque>
#include <unordered_map>

namespace gr::importer {

// A buffer is read when something in it is first asked for: one that holds pictures only need not be there.
class GltfBuffers {
public:
    struct View {
        std::string_view bytes;
        std::size_t stride = 0;  // in bytes, from one element to the next; 0: they follow each other
    };

    // binary: the part of a .glb file that is its first buffer, if it has one.
    GltfBuffers(const GltfDocument& document, std::optional<std::string_view> binary, const OtherFile& others)
        : document_(document), binary_(binary), others_(others), buffers_(document.count(bufferKind)) {}

    // What EXT_meshopt_compression has packed is unpacked. The bytes stay as long as this object.
    View view(std::size_t index);

private:
    std::string_view buffer(std::size_t index);
    std::string_view load(std::size_t index, const JsonObject& buffer);
    // A part of the buffer that an object names, with byteOffset and byteLength.
    std::string_view part(const JsonObject& owner);

    const GltfDocument& document_;
    std::optional<std::string_view> binary_;
    const OtherFile& others_;
    std::vector<std::optional<std::string_view>> buffers_;
    std::unordered_map<std::size_t, View> unpackedViews_;
    std::deque<std::string> owned_;
};

}  // namespace gr::importer
