#include "gr/mesh/import/scene_flattener.h"

#include <algorithm>
#include <array>
#include <limits>

namespace gr::importer {
namespace {

constexpr std::size_t mostCorners = std::numeric_limits<int>::max();
constexpr float mostCoordinate = 1e18f;  // its square is still a float
constexpr int none = -1;  // the number of a vertex that is nowhere

bool isFace(const aiFace& face) {
    return face.mNumIndices >= 3;
}

}  // namespace

SceneFlattener::SceneFlattener(const aiScene& scene, bool withNormals) : withNormals_(withNormals) {
    const std::vector<Placed> meshes = placedMeshes(scene);
    std::size_t count = 0;
    for (const Placed& placed : meshes) {
        const aiMesh& mesh = *placed.mesh;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            if (isFace(mesh.mFaces[f]))
                count += mesh.mFaces[f].mNumIndices;
            else
                ++linesAndPoints;
        }
        if (count > mostCorners) throw Failure("its faces have more than 2147483647 corners in all");
    }
    if (count == 0) throw Failure("it has no faces");
    corners.reserve(count);
    // In most meshes six triangles meet at a vertex.
    table_.reserve(count / 6);
    vertices.reserve(count / 6);
    for (const Placed& placed : meshes) add(placed);
}

std::vector<SceneFlattener::Placed> SceneFlattener::placedMeshes(const aiScene& scene) const {
    std::vector<Placed> meshes;
    std::vector<std::pair<const aiNode*, aiMatrix4x4t<double>>> open;
    if (scene.mRootNode != nullptr) open.push_back({scene.mRootNode, {}});
    while (!open.empty()) {
        const auto [node, above] = open.back();
        open.pop_back();
        const aiMatrix4x4t<double> matrix = above * aiMatrix4x4t<double>(node->mTransformation);
        for (unsigned i = 0; i < node->mNumMeshes; ++i) {
            if (node->mMeshes[i] >= scene.mNumMeshes) throw Failure("a node names a mesh that it has not");
            meshes.push_back({scene.mMeshes[node->mMeshes[i]], matrix});
        }
        for (unsigned i = node->mNumChildren; i-- > 0;) open.push_back({node->mChildren[i], matrix});
    }
    return meshes;
}

void SceneFlattener::add(const Placed& placed) {
    addVertices(placed);
    addNormals(placed);
    const bool isMirrored = aiMatrix3x3t<double>(placed.matrix).Determinant() < 0;
    for (unsigned f = 0; f < placed.mesh->mNumFaces; ++f)
        if (isFace(placed.mesh->mFaces[f])) addFace(placed.mesh->mFaces[f], isMirrored);
}

void SceneFlattener::addVertices(const Placed& placed) {
    const aiMesh& mesh = *placed.mesh;
    const bool isInPlace = placed.matrix == aiMatrix4x4t<double>();
    const auto place = [&](unsigned i) -> core::Vec3f {
        const aiVector3D& given = mesh.mVertices[i];
        if (isInPlace) return {given.x, given.y, given.z};
        const aiVector3t<double> moved = placed.matrix * aiVector3t<double>(given.x, given.y, given.z);
        return {moved.x, moved.y, moved.z};
    };
    // In most files a corner is like one of the few before it, which is quick to see. What others need is fetched
    // ahead.
    constexpr unsigned few = 8, ahead = 16, kept = 32;
    struct Corner {
        core::Vec3f place = core::Vec3f(std::numeric_limits<float>::quiet_NaN());
        unsigned back = 0;  // how far before it the one is that it is like, or 0
        std::uint64_t hash = 0;
    };
    std::array<Corner, kept> recent;
    const auto prepare = [&](unsigned i) {
        if (i >= mesh.mNumVertices) return;
        Corner& corner = recent[i % kept];
        corner.place = place(i);
        for (corner.back = 1; corner.back <= few; ++corner.back)
            if (recent[(i - corner.back) % kept].place == corner.place) return;
        corner.back = 0;
        corner.hash = table_.hash(corner.place);
        table_.fetchSlot(corner.hash);
    };
    for (unsigned i = 0; i < ahead; ++i) prepare(i);
    numbers_.resize(mesh.mNumVertices);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        prepare(i + ahead);
        const Corner& next = recent[(i + ahead / 2) % kept];
        if (next.back == 0) table_.fetchPlace(vertices.data(), next.hash);
        const Corner& corner = recent[i % kept];
        numbers_[i] = corner.back > 0 ? numbers_[i - corner.back] : addVertex(corner.place, corner.hash);
    }
}

int SceneFlattener::addVertex(const core::Vec3f& v, std::uint64_t hash) {
    if (!(std::abs(v.x) <= mostCoordinate && std::abs(v.y) <= mostCoordinate && std::abs(v.z) <= mostCoordinate))
        return none;
    const int number = static_cast<int>(vertices.size());
    vertices.push_back(v);
    const int first = table_.firstLike(vertices.data(), number, hash);
    if (first != number) vertices.pop_back();
    return first;
}

void SceneFlattener::addNormals(const Placed& placed) {
    const aiMesh& mesh = *placed.mesh;
    packed_.clear();
    if (!withNormals_ || !mesh.HasNormals()) return;
    // Corners so far have none.
    if (normals.empty()) normals.assign(corners.size(), noNormal);
    const bool isInPlace = placed.matrix == aiMatrix4x4t<double>();
    // Normals go by the transposed inverse.
    aiMatrix3x3t<double> matrix(placed.matrix);
    matrix.Inverse().Transpose();
    packed_.resize(mesh.mNumVertices, noNormal);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D& given = mesh.mNormals[i];
        core::Vec3f normal(given.x, given.y, given.z);
        if (!isInPlace) {
            aiVector3t<double> turned = matrix * aiVector3t<double>(given.x, given.y, given.z);
            turned /= turned.Length();
            normal = {turned.x, turned.y, turned.z};
        }
        const float size = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
        if (size > 0 && size < core::infinity) packed_[i] = packNormal(normal);
    }
}

void SceneFlattener::addFace(const aiFace& face, bool isMirrored) {
    const std::size_t first = corners.size();
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
        const unsigned vertex = face.mIndices[isMirrored ? face.mNumIndices - 1 - i : i];
        if (vertex >= numbers_.size())
            throw Failure("a face names vertex " + std::to_string(static_cast<int>(vertex)) + " of " +
                          std::to_string(numbers_.size()));
        if (numbers_[vertex] == none) throw Failure("a coordinate is not a number from -1e+18 to 1e+18");
        corners.push_back(numbers_[vertex]);
        if (!packed_.empty())
            normals.push_back(packed_[vertex]);
        else if (!normals.empty())
            normals.push_back(noNormal);
    }
    endFace(first);
}

void SceneFlattener::endFace(std::size_t firstCorner) {
    const bool isTriangle = corners.size() - firstCorner == 3;
    if (isTriangle && ends.empty()) return;
    // All faces before the first one that is no triangle were some.
    if (ends.empty())
        for (std::size_t end = 3; end <= firstCorner; end += 3) ends.push_back(static_cast<int>(end));
    ends.push_back(static_cast<int>(corners.size()));
}

}  // namespace gr::importer
