// The nodes of a glTF file and where they stand.
#pragma once

#include "gr/mesh/import/gltf/document.h"

namespace gr::importer {

// translation: 3 numbers, rotation: a quaternion's 4 with the real one last, scale: 3; each may be empty.
// place: of what is moved so, for a message.
glm::dmat4 transformOf(const std::vector<double>& translation, const std::vector<double>& rotation,
                       const std::vector<double>& scale, const std::string& place);

// number: gives the 16 numbers of a matrix, column by column. The last row is 0 0 0 1 in all that turns, scales and
// moves, and is taken as that.
template<class Number>
glm::dmat4 affine(Number&& number) {
    glm::dmat4 matrix(1);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) matrix[column][row] = number(static_cast<std::size_t>(4 * column + row));
    return matrix;
}

class NodeTree {
public:
    // Throws Failure where a node has two parents or is below itself.
    explicit NodeTree(const GltfDocument& document);

    // From a node's space to the scene's.
    const glm::dmat4& matrix(std::size_t node) const { return matrices_[node]; }
    // The nodes of the scene that is to be read, each before those below it.
    std::vector<std::size_t> sceneNodes() const;

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void findParents();
    void findMatrices();
    [[noreturn]] void failCycle(std::size_t node) const;
    std::vector<std::size_t> sceneRoots() const;
    std::vector<std::size_t> allRoots() const;
    std::vector<std::size_t> below(const std::vector<std::size_t>& roots) const;

    const GltfDocument& document_;
    std::vector<std::size_t> parents_;
    std::vector<std::vector<std::size_t>> children_;
    std::vector<glm::dmat4> matrices_;
};

}  // namespace gr::importer
