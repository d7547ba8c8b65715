#include "gr/mesh/import/gltf/instances.h"

#include "gr/mesh/import/gltf/node_tree.h"

namespace gr::importer {
namespace {

std::vector<double> numbersOf(const std::optional<Accessor>& accessor, std::size_t element) {
    std::vector<double> numbers;
    for (std::size_t i = 0; accessor && i < accessor->width; ++i) numbers.push_back(accessor->number(element, i));
    return numbers;
}

}  // namespace

Instances::Instances(const GltfDocument& document, GltfBuffers& buffers, const JsonObject& node) {
    const std::optional<JsonObject> extension = node.extension("EXT_mesh_gpu_instancing");
    if (!extension) return;
    place_ = extension->place();
    const std::optional<JsonObject> attributes = extension->object("attributes");
    if (!attributes || attributes->keys().empty()) throw Failure(extension->subject() + " has no \"attributes\"");
    std::optional<std::size_t> count;
    // Others than these three are the file's own, and count instances like them.
    for (const std::string& name : attributes->keys()) {
        Accessor accessor =
            readAccessor(document, buffers, document.neededNamed(*attributes, name.c_str(), accessorKind));
        if (count && *count != accessor.count)
            throw Failure(extension->subject() + " has " + std::to_string(accessor.count) + " of " + name + " for " +
                          std::to_string(*count) + " of others");
        count = accessor.count;
        const bool isRotation = name == "ROTATION";
        if (name != "TRANSLATION" && name != "SCALE" && !isRotation) continue;
        accessor.expectType(name, {isRotation ? "VEC4" : "VEC3"});
        (isRotation ? rotations_ : name == "SCALE" ? scales_ : translations_) = std::move(accessor);
    }
    count_ = *count;
}

glm::dmat4 Instances::matrix(std::size_t instance) const {
    return transformOf(numbersOf(translations_, instance), numbersOf(rotations_, instance),
                       numbersOf(scales_, instance), place_);
}

}  // namespace gr::importer
