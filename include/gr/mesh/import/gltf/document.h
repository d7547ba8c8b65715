// The JSON part of a glTF file: lists of things that name each other by their numbers.
#pragma once

#include "gr/mesh/import/gltf/json_object.h"

#include <memory>

namespace gr::importer {

// A list of the file, and the word for one thing in it.
struct GltfKind {
    const char* list;
    const char* word;
};
inline constexpr GltfKind accessorKind{"accessors", "accessor"}, bufferKind{"buffers", "buffer"},
    bufferViewKind{"bufferViews", "bufferView"}, materialKind{"materials", "material"}, meshKind{"meshes", "mesh"},
    nodeKind{"nodes", "node"}, sceneKind{"scenes", "scene"}, skinKind{"skins", "skin"};

class GltfDocument {
public:
    // Throws Failure where the text is not glTF 2, or requires an extension that would change faces and is not known.
    explicit GltfDocument(std::string_view text);
    ~GltfDocument();
    GltfDocument(const GltfDocument&) = delete;
    GltfDocument& operator=(const GltfDocument&) = delete;

    const JsonObject& root() const { return *root_; }
    std::size_t count(const GltfKind& kind) const;
    JsonObject item(const GltfKind& kind, std::size_t index) const;
    // The number that something has under a key; Failure where the list has none of that number.
    std::optional<std::size_t> named(const JsonObject& from, const char* key, const GltfKind& kind) const;
    std::size_t neededNamed(const JsonObject& from, const char* key, const GltfKind& kind) const;
    // The numbers in a list.
    std::vector<std::size_t> allNamed(const JsonObject& from, const char* key, const GltfKind& kind) const;

private:
    std::size_t checked(const JsonObject& from, const char* key, const nlohmann::json& value,
                        const GltfKind& kind) const;

    std::unique_ptr<nlohmann::json> json_;
    std::optional<JsonObject> root_;
};

}  // namespace gr::importer
