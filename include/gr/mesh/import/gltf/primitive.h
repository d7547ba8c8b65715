// A primitive of a mesh: triangles of one material.
#pragma once

#include "gr/mesh/import/gltf/primitive_source.h"

namespace gr::importer {

// A joint that moves a vertex, and how much.
struct Influence {
    std::uint32_t joint = 0;
    float weight = 0;
};

// In the mesh's own space. Vertices that no triangle uses may be left out.
struct Primitive {
    std::string place;  // such as "mesh 0's primitive 1"
    std::string material;
    std::vector<glm::dvec3> vertices;
    // Of the vertices, or empty:
    std::vector<core::Vec3f> normals;  // of any length
    std::vector<core::Vec2f> uvs;  // v upwards
    std::vector<core::Rgbf> colours;
    std::vector<Influence> influences;  // influenceCount for each vertex; their weights are 1 in all
    std::size_t influenceCount = 0;
    std::vector<std::uint32_t> corners;  // three for each triangle
    std::uint64_t linesAndPoints = 0;
};

// weights: of the morph targets; those that have none do nothing. isSkinned: it must have joints.
// One without positions is empty, as glTF has it.
Primitive readPrimitive(const GltfDocument& document, GltfBuffers& buffers, const JsonObject& primitive,
                        const std::vector<double>& weights, bool isSkinned);

// How vertices make triangles. mode: glTF's number, 4 to 6. Turns a list of vertices into one of triangles' corners;
// what is left over is no triangle. Strips and fans lose those triangles that are there for the sake of their form.
std::vector<std::uint32_t> trianglesOf(std::vector<std::uint32_t> vertices, std::uint64_t mode);

}  // namespace gr::importer
