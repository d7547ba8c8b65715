// Where the numbers of a primitive are: in accessors, or in what Draco unpacked.
#pragma once

#include "gr/mesh/import/gltf/draco.h"

namespace gr::importer {

class PrimitiveSource {
public:
    // primitive: must outlive it.
    PrimitiveSource(const GltfDocument& document, GltfBuffers& buffers, const JsonObject& primitive);

    const std::string& place() const { return primitive_.place(); }
    bool hasPositions() const { return positions_.has_value(); }
    const Accessor& positions() const { return *positions_; }
    std::size_t vertexCount() const { return positions_ ? positions_->count : 0; }
    // Draco unpacks triangles, whatever they were before.
    bool isTriangleList() const { return draco_.has_value(); }
    // Numbers of vertices, in the order in which they are drawn. Throws Failure where there is no such vertex.
    std::vector<std::uint32_t> indices() const;
    // Throws Failure unless it has one element for each vertex.
    std::optional<Accessor> attribute(const std::string& name) const;
    // The same of what morph target `target` adds.
    std::optional<Accessor> targetAttribute(std::size_t target, const std::string& name) const;
    std::size_t targetCount() const;

private:
    std::optional<Accessor> find(const JsonObject& attributes, const std::string& name) const;
    std::optional<Accessor> counted(std::optional<Accessor> accessor, const std::string& name) const;
    std::vector<std::uint32_t> indicesOf(const Accessor& accessor) const;

    const GltfDocument& document_;
    GltfBuffers& buffers_;
    const JsonObject& primitive_;
    std::optional<DracoMesh> draco_;
    std::optional<Accessor> positions_;
};

}  // namespace gr::importer
