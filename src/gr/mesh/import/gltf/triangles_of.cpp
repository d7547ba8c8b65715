// How points in a row make triangles, as glTF tells it: https://registry.khronos.org/glTF, "Mesh Primitive Modes".
#include "gr/mesh/import/gltf/primitive.h"

namespace gr::importer {
namespace {

enum Mode : std::uint64_t { triangles = 4, strip = 5, fan = 6 };

// Strips go around corners, and from one part to another, by triangles that have a vertex twice.
void addUnlessFlat(std::vector<std::uint32_t>& corners, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) corners.insert(corners.end(), {a, b, c});
}

}  // namespace

std::vector<std::uint32_t> trianglesOf(std::vector<std::uint32_t> vertices, std::uint64_t mode) {
    if (mode == Mode::triangles) {
        vertices.resize(vertices.size() / 3 * 3);
        return vertices;
    }
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i + 2 < vertices.size(); ++i) {
        if (mode == Mode::fan)
            addUnlessFlat(corners, vertices[0], vertices[i + 1], vertices[i + 2]);
        else  // every second one is turned
            addUnlessFlat(corners, vertices[i], vertices[i + 1 + i % 2], vertices[i + 2 - i % 2]);
    }
    return corners;
}

}  // namespace gr::importer
