#include "gr/mesh/import/gltf/scene_placer.h"

#include "gr/mesh/import/gltf/skin.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace gr::importer {
namespace {

std::size_t cornerCount(const std::vector<Primitive>& primitives) {
    std::size_t count = 0;
    for (const Primitive& primitive : primitives) count += primitive.corners.size();
    return count;
}

}  // namespace

SourceMesh ScenePlacer::build() {
    for (const Placed& placed : placedMeshes()) {
        Shared& shared = placed.use->second;
        if (!shared.primitives) shared.primitives = readPrimitives(placed.use->first);
        place(placed.node, document_.item(meshKind, placed.use->first.mesh), *shared.primitives);
        if (--shared.nodesLeft == 0) shared.primitives.reset();
    }
    if (mesh_.corners.empty()) throw Failure("it has no faces");
    return std::move(mesh_);
}

std::vector<ScenePlacer::Placed> ScenePlacer::placedMeshes() {
    std::vector<Placed> placed;
    for (const std::size_t index : tree_.sceneNodes()) {
        const JsonObject node = document_.item(nodeKind, index);
        const std::optional<std::size_t> mesh = document_.named(node, "mesh", meshKind);
        if (!mesh) continue;
        // A node's own weights are instead of its mesh's.
        const JsonObject& weighted = node.find("weights") != nullptr ? node : document_.item(meshKind, *mesh);
        const auto use = uses_.try_emplace({*mesh, node.find("skin") != nullptr, weighted.numbers("weights")}).first;
        ++use->second.nodesLeft;
        placed.push_back({index, use});
    }
    return placed;
}

std::vector<Primitive> ScenePlacer::readPrimitives(const Use& use) {
    const JsonObject mesh = document_.item(meshKind, use.mesh);
    const nlohmann::json& list = mesh.list("primitives");
    std::vector<Primitive> primitives;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const JsonObject primitive(list[i], mesh.place() + "'s primitive " + std::to_string(i));
        primitives.push_back(readPrimitive(document_, buffers_, primitive, use.weights, use.isSkinned));
    }
    return primitives;
}

void ScenePlacer::place(std::size_t nodeIndex, const JsonObject& mesh, const std::vector<Primitive>& primitives) {
    const JsonObject node = document_.item(nodeKind, nodeIndex);
    std::string name = mesh.text("name");
    if (name.empty()) name = node.text("name");
    const std::optional<std::size_t> skin = document_.named(node, "skin", skinKind);
    if (skin)
        placeSkinned(node, *skin, name, primitives);
    else
        placeInstances(node, tree_.matrix(nodeIndex), name, primitives);
}

void ScenePlacer::placeInstances(const JsonObject& node, const glm::dmat4& matrix, const std::string& name,
                                 const std::vector<Primitive>& primitives) {
    const Instances instances(document_, buffers_, node);
    countLinesAndPoints(primitives, instances.count());
    const std::size_t corners = cornerCount(primitives);
    if (corners == 0) return;
    // Told before it takes minutes to find out: few bytes make many instances.
    if (instances.count() > (std::numeric_limits<int>::max() - mesh_.corners.size()) / corners)
        throw Failure("its faces have more than 2147483647 corners in all");
    for (std::size_t i = 0; i < instances.count(); ++i) {
        const glm::dmat4 placed = matrix * instances.matrix(i);
        for (const Primitive& primitive : primitives)
            if (!primitive.corners.empty()) placer_.place(primitive, name, placed);
    }
}

// Where its joints are is where a skinned mesh is: its node's own place does not count.
void ScenePlacer::placeSkinned(const JsonObject& node, std::size_t skin, const std::string& name,
                               const std::vector<Primitive>& primitives) {
    if (node.extension("EXT_mesh_gpu_instancing"))
        throw Failure(node.subject() + " has instances and a skin, which glTF does not join");
    countLinesAndPoints(primitives, 1);
    const auto [joints, isNew] = joints_.try_emplace(skin);
    if (isNew) joints->second = jointMatrices(document_, buffers_, tree_, skin);
    for (const Primitive& primitive : primitives)
        if (!primitive.corners.empty()) placer_.placeSkinned(primitive, name, joints->second);
}

void ScenePlacer::countLinesAndPoints(const std::vector<Primitive>& primitives, std::size_t times) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    for (const Primitive& primitive : primitives) {
        const std::uint64_t few = std::min(primitive.linesAndPoints, most),
                            all = few * std::min<std::uint64_t>(times, most);
        mesh_.linesAndPoints = static_cast<std::uint32_t>(std::min(most, mesh_.linesAndPoints + std::min(all, most)));
    }
}

}  // namespace gr::importer
