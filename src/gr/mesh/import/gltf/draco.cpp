#include "gr/mesh/import/gltf/draco.h"

#include "gr/mesh/import/gltf/words.h"

#include <draco/compression/decode.h>

namespace gr::importer {
namespace {

Component componentOf(draco::DataType type, const std::string& name, const std::string& place) {
    switch (type) {
        case draco::DT_INT8:
            return Component::int8;
        case draco::DT_UINT8:
            return Component::uint8;
        case draco::DT_INT16:
            return Component::int16;
        case draco::DT_UINT16:
            return Component::uint16;
        case draco::DT_INT32:
            return Component::int32;
        case draco::DT_UINT32:
            return Component::uint32;
        case draco::DT_FLOAT32:
            return Component::float32;
        default:
            throw Failure("its " + place + " has " + name + " of a kind that glTF has not");
    }
}

Accessor accessorOf(const draco::PointAttribute& attribute, std::size_t count, const std::string& name,
                    const std::string& place) {
    Accessor accessor;
    accessor.place = place + "'s " + name;
    accessor.width = static_cast<std::size_t>(attribute.num_components());
    accessor.type = accessor.width == 1 ? "SCALAR" : "VEC" + std::to_string(accessor.width);
    accessor.component = componentOf(attribute.data_type(), name, place);
    accessor.count = count;
    accessor.stride = accessor.width * sizeOf(accessor.component);
    const auto bytes = std::make_shared<std::string>(count * accessor.stride, '\0');
    for (std::size_t i = 0; i < count; ++i) {
        // Points of one value share it.
        const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(static_cast<unsigned>(i)));
        if (value.value() >= attribute.size()) throw Failure("its " + place + " is not whole Draco data");
        attribute.GetValue(value, bytes->data() + i * accessor.stride);
    }
    accessor.bytes = bytes->data();
    accessor.owned = bytes;
    return accessor;
}

std::unique_ptr<draco::Mesh> decode(std::string_view packed, const std::string& place) {
    draco::DecoderBuffer buffer;
    buffer.Init(packed.data(), packed.size());
    draco::Decoder decoder;
    draco::StatusOr<std::unique_ptr<draco::Mesh>> mesh = decoder.DecodeMeshFromBuffer(&buffer);
    if (!mesh.ok())
        throw Failure("its " + place + " is not whole Draco data: " + inQuotes(mesh.status().error_msg_string()));
    return std::move(mesh).value();
}

}  // namespace

DracoMesh unpackDraco(const JsonObject& extension, std::string_view packed, const std::string& place) {
    const std::unique_ptr<draco::Mesh> mesh = decode(packed, place);
    DracoMesh unpacked;
    unpacked.vertexCount = mesh->num_points();
    unpacked.indices.reserve(3 * static_cast<std::size_t>(mesh->num_faces()));
    for (unsigned f = 0; f < mesh->num_faces(); ++f)
        for (const draco::PointIndex& point : mesh->face(draco::FaceIndex(f)))
            unpacked.indices.push_back(point.value());
    const std::optional<JsonObject> attributes = extension.object("attributes");
    if (!attributes) throw Failure(extension.subject() + " has no \"attributes\"");
    for (const std::string& name : attributes->keys()) {
        const std::uint64_t number = attributes->neededWhole(name.c_str());
        const draco::PointAttribute* attribute = number > std::numeric_limits<std::uint32_t>::max()
                                                     ? nullptr
                                                     : mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(number));
        if (attribute == nullptr)
            throw Failure(extension.subject() + " names " + name + " by " + std::to_string(number) +
                          ", which its Draco data has not");
        unpacked.attributes.emplace(name, accessorOf(*attribute, unpacked.vertexCount, name, place));
    }
    return unpacked;
}

}  // namespace gr::importer
