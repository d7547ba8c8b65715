#include "gr/mesh/import/gltf/primitive_placer.h"

namespace gr::importer {
namespace {

// Moves normals as the transposed inverse does, but for their length. It needs no inverse, so that a matrix that
// flattens does no harm; and where the matrix mirrors it would turn normals round, which the sign undoes.
glm::dmat3 normalMatrix(const glm::dmat4& matrix) {
    const glm::dvec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
    const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    return glm::dot(x, cofactors[0]) < 0 ? -cofactors : cofactors;
}

bool mirrors(const glm::dmat4& matrix) {
    return glm::determinant(glm::dmat3(matrix)) < 0;
}

PackedNormal packed(const glm::dvec3& normal) {
    const double length = glm::length(normal);
    if (!(length > 0 && length <= std::numeric_limits<double>::max())) return noNormal;
    return packNormal(core::Vec3f(normal / length));
}

}  // namespace

void PrimitivePlacer::place(const Primitive& primitive, const std::string& name, const glm::dmat4& matrix) {
    begin(primitive);
    const glm::dmat3 cofactors = normalMatrix(matrix);
    for (std::size_t i = 0; i < primitive.vertices.size(); ++i) addVertex(primitive, i, matrix, cofactors);
    isMirrored_.assign(1, mirrors(matrix));
    addFaces(primitive, name);
}

void PrimitivePlacer::placeSkinned(const Primitive& primitive, const std::string& name,
                                   const std::vector<glm::dmat4>& joints) {
    begin(primitive);
    isMirrored_.clear();
    for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
        glm::dmat4 matrix(0);
        for (std::size_t k = 0; k < primitive.influenceCount; ++k) {
            const Influence& influence = primitive.influences[i * primitive.influenceCount + k];
            if (influence.weight == 0) continue;
            if (influence.joint >= joints.size())
                throw Failure("its " + primitive.place + " names joint " + std::to_string(influence.joint) + " of " +
                              std::to_string(joints.size()));
            matrix += static_cast<double>(influence.weight) * joints[influence.joint];
        }
        addVertex(primitive, i, matrix, normalMatrix(matrix));
        isMirrored_.push_back(mirrors(matrix));
    }
    addFaces(primitive, name);
}

void PrimitivePlacer::begin(const Primitive& primitive) {
    const std::size_t count = mesh_.vertices.size();
    if (primitive.vertices.size() > std::numeric_limits<int>::max() - count)
        throw Failure("its meshes have more than 2147483647 vertices in all");
    firstVertex_ = static_cast<int>(count);
    normals_.clear();
}

void PrimitivePlacer::addVertex(const Primitive& primitive, std::size_t vertex, const glm::dmat4& matrix,
                                const glm::dmat3& cofactors) {
    mesh_.vertices.emplace_back(matrix * glm::dvec4(primitive.vertices[vertex], 1));
    if (!primitive.normals.empty()) normals_.push_back(packed(cofactors * glm::dvec3(primitive.normals[vertex])));
}

void PrimitivePlacer::addFaces(const Primitive& primitive, const std::string& name) {
    mesh_.beginGroup(name, primitive.material);
    for (std::size_t i = 0; i < primitive.corners.size(); i += 3) {
        const std::uint32_t a = primitive.corners[i];
        const bool isTurned = isMirrored_.size() == 1 ? isMirrored_[0] : isMirrored_[a];
        addCorner(primitive, a);
        addCorner(primitive, primitive.corners[isTurned ? i + 2 : i + 1]);
        addCorner(primitive, primitive.corners[isTurned ? i + 1 : i + 2]);
        mesh_.endFace();
    }
}

void PrimitivePlacer::addCorner(const Primitive& primitive, std::uint32_t vertex) {
    const std::size_t corner = mesh_.corners.size();
    mesh_.corners.push_back(firstVertex_ + static_cast<int>(vertex));
    if (!normals_.empty()) setOf(corner, mesh_.normals, normals_[vertex], noNormal);
    if (!primitive.uvs.empty()) setOf(corner, mesh_.uvs, primitive.uvs[vertex], core::Vec2f(0));
    if (!primitive.colours.empty()) setOf(corner, mesh_.colours, primitive.colours[vertex], core::Rgbf(1));
}

}  // namespace gr::importer
