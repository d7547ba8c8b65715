#include "gr/mesh/import/gltf/primitive_source.h"

#include <nlohmann/json.hpp>
#include <numeric>

namespace gr::importer {
namespace {

// The extension's buffer view holds Draco's data, which is no list of elements.
std::optional<DracoMesh> dracoOf(const GltfDocument& document, GltfBuffers& buffers, const JsonObject& primitive) {
    const std::optional<JsonObject> extension = primitive.extension("KHR_draco_mesh_compression");
    if (!extension) return {};
    const std::size_t view = document.neededNamed(*extension, "bufferView", bufferViewKind);
    return unpackDraco(*extension, buffers.view(view).bytes, primitive.place());
}

// What highest number a component has: glTF keeps it from indices, because it would begin a new strip or fan.
std::uint32_t restartOf(Component component) {
    return static_cast<std::uint32_t>((std::uint64_t{1} << 8 * sizeOf(component)) - 1);
}

}  // namespace

PrimitiveSource::PrimitiveSource(const GltfDocument& document, GltfBuffers& buffers, const JsonObject& primitive)
    : document_(document), buffers_(buffers), primitive_(primitive), draco_(dracoOf(document, buffers, primitive)) {
    const std::optional<JsonObject> attributes = primitive.object("attributes");
    if (!attributes) throw Failure(primitive.subject() + " has no \"attributes\"");
    positions_ = find(*attributes, "POSITION");
    if (positions_) positions_->expectType("POSITION", {"VEC3"});
}

std::optional<Accessor> PrimitiveSource::find(const JsonObject& attributes, const std::string& name) const {
    const std::optional<std::size_t> index = document_.named(attributes, name.c_str(), accessorKind);
    if (!index) return {};
    const bool isPacked = draco_ && draco_->attributes.contains(name);
    if (!isPacked) return readAccessor(document_, buffers_, *index);
    Accessor accessor = draco_->attributes.at(name);
    accessor.isNormalised = document_.item(accessorKind, *index).flag("normalized");
    return accessor;
}

std::optional<Accessor> PrimitiveSource::counted(std::optional<Accessor> accessor, const std::string& name) const {
    if (accessor && accessor->count != vertexCount())
        throw Failure("its " + place() + " has " + std::to_string(accessor->count) + " of " + name + " for " +
                      std::to_string(vertexCount()) + " of POSITION");
    return accessor;
}

std::optional<Accessor> PrimitiveSource::attribute(const std::string& name) const {
    return counted(find(*primitive_.object("attributes"), name), name);
}

std::size_t PrimitiveSource::targetCount() const {
    return primitive_.list("targets").size();
}

std::optional<Accessor> PrimitiveSource::targetAttribute(std::size_t target, const std::string& name) const {
    const JsonObject attributes(primitive_.list("targets")[target], place() + "'s target " + std::to_string(target));
    const std::optional<std::size_t> index = document_.named(attributes, name.c_str(), accessorKind);
    if (!index) return {};
    return counted(readAccessor(document_, buffers_, *index), "target " + std::to_string(target) + "'s " + name);
}

std::vector<std::uint32_t> PrimitiveSource::indices() const {
    if (draco_) {
        for (const std::uint32_t index : draco_->indices)
            if (index >= vertexCount()) throw Failure("its " + place() + " is not whole Draco data");
        return draco_->indices;
    }
    const std::optional<std::size_t> named = document_.named(primitive_, "indices", accessorKind);
    if (named) return indicesOf(readAccessor(document_, buffers_, *named));
    if (vertexCount() > std::numeric_limits<std::uint32_t>::max())
        throw Failure("its " + place() + " has more than 4294967295 vertices");
    std::vector<std::uint32_t> all(vertexCount());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

std::vector<std::uint32_t> PrimitiveSource::indicesOf(const Accessor& accessor) const {
    accessor.expectType("an index", {"SCALAR"});
    accessor.expectUnsigned("an index");
    const std::uint32_t restart = restartOf(accessor.component);
    std::vector<std::uint32_t> indices(accessor.count);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        indices[i] = accessor.whole(i, 0);
        if (indices[i] == restart)
            throw Failure("its " + accessor.place + " has index " + std::to_string(restart) +
                          ", which glTF keeps for restarts and allows nowhere");
        if (indices[i] >= vertexCount())
            throw Failure("its " + place() + " names vertex " + std::to_string(indices[i]) + " of " +
                          std::to_string(vertexCount()));
    }
    return indices;
}

}  // namespace gr::importer
