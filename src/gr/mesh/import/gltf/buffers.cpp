#include "gr/mesh/import/gltf/buffers.h"

#include "gr/mesh/import/gltf/meshopt.h"
#include "gr/mesh/import/gltf/uri.h"
#include "gr/mesh/import/gltf/words.h"

namespace gr::importer {

GltfBuffers::View GltfBuffers::view(std::size_t index) {
    const auto unpacked = unpackedViews_.find(index);
    if (unpacked != unpackedViews_.end()) return unpacked->second;
    const JsonObject view = document_.item(bufferViewKind, index);
    const std::optional<JsonObject> meshopt = view.extension("EXT_meshopt_compression");
    if (!meshopt) return {part(view), view.whole("byteStride", 0)};
    owned_.push_back(unpackMeshopt(*meshopt, part(*meshopt)));
    return unpackedViews_[index] = {owned_.back(), meshopt->neededWhole("byteStride")};
}

std::string_view GltfBuffers::part(const JsonObject& owner) {
    const std::size_t index = document_.neededNamed(owner, "buffer", bufferKind);
    const std::uint64_t offset = owner.whole("byteOffset", 0), length = owner.neededWhole("byteLength");
    const std::string_view bytes = buffer(index);
    if (offset > bytes.size() || length > bytes.size() - offset)
        throw Failure(owner.subject() + " has " + std::to_string(length) + " bytes from byte " +
                      std::to_string(offset) + " on, more than buffer " + std::to_string(index) + " with its " +
                      std::to_string(bytes.size()));
    return bytes.substr(offset, length);
}

std::string_view GltfBuffers::buffer(std::size_t index) {
    std::optional<std::string_view>& known = buffers_[index];
    if (known) return *known;
    const JsonObject buffer = document_.item(bufferKind, index);
    const std::uint64_t length = buffer.neededWhole("byteLength");
    const std::string_view bytes = load(index, buffer);
    // There may be more, such as what fills the last word.
    if (bytes.size() < length)
        throw Failure(buffer.subject() + " has " + std::to_string(bytes.size()) + " bytes instead of " +
                      std::to_string(length));
    known = bytes.substr(0, length);
    return *known;
}

std::string_view GltfBuffers::load(std::size_t index, const JsonObject& buffer) {
    if (buffer.find("uri") == nullptr) {
        if (index == 0 && binary_) return *binary_;
        throw Failure(buffer.subject() + " has no \"uri\", and " +
                      (index == 0 ? "the file has no binary part" : "only buffer 0 can be the file's binary part"));
    }
    const std::string uri = buffer.text("uri");
    if (isDataUri(uri)) {
        std::optional<std::string> data = dataOf(uri);
        if (!data) throw Failure(buffer.subjectOf("uri") + " is not whole base64 text");
        owned_.push_back(std::move(*data));
        return owned_.back();
    }
    const std::optional<std::string> path = pathOf(uri);
    if (!path)
        throw Failure(buffer.subject() + " is at " + inQuotes(uri) + ", which is not below the file's own folder");
    try {
        return others_(*path);
    } catch (const Failure& failure) {
        throw Failure(buffer.subject() + ": " + failure.what());
    }
}

}  // namespace gr::importer
