#include "core/allocated.h"
#include "gr/database/database.h"
#include "gr/database/object_count.h"

namespace gr {
namespace {

// Behind a node: its name and its matrix.
std::size_t partBytes(const Node& node) {
    return core::allocatedBytes(node.name) + (node.matrix ? core::allocatedBytes(sizeof(glm::dmat4)) : 0);
}

std::size_t meshBytes(const Polyhedron& mesh) {
    constexpr std::size_t owners = 3 * sizeof(void*);  // what its shared pointers count in
    return core::allocatedBytes(sizeof(Polyhedron)) + core::allocatedBytes(owners) + core::allocatedBytes(mesh.bytes());
}

}  // namespace

DatabaseStatistics Database::statistics() const {
    DatabaseStatistics statistics;
    statistics.objects = countObjects(root_).at(&root_);

    statistics.nodeBytes = core::allocatedByTable(index_) + partBytes(root_);
    std::unordered_set<const Polyhedron*> meshes;
    for (const auto& node : index_) {
        ++statistics.nodes[node->content.index()];
        if (const auto* mesh = std::get_if<PolyhedronNode>(&node->content)) {
            statistics.nodeBytes += core::allocatedBytes(mesh->file);
            meshes.insert(mesh->polyhedron.get());
        }
        statistics.nodeBytes += core::allocatedBytes(sizeof(Node)) + partBytes(*node);
    }
    statistics.nodeBytes += core::allocatedByTable(instancesOf_);
    for (const auto& [target, instances] : instancesOf_) statistics.nodeBytes += core::allocatedByTable(instances);

    statistics.nodeBytes += core::allocatedByTable(autoNumbers_);
    for (const auto& [parent, numbers] : autoNumbers_) statistics.nodeBytes += core::allocatedByTable(numbers);

    statistics.meshes = meshes.size();
    statistics.meshBytes = meshFiles_.bytes();
    for (const Polyhedron* mesh : meshes) {
        statistics.triangles += mesh->triangleCount();
        statistics.meshBytes += meshBytes(*mesh);
    }

    statistics.materials = materials_.size();
    statistics.lights = lights_.size();
    statistics.materialBytes = core::allocatedByTable(materials_) + core::allocatedByTable(lights_);
    for (const auto& [name, material] : materials_)
        statistics.materialBytes +=
            core::allocatedBytes(name) + core::allocatedBytes(material.name) + core::allocatedBytes(material.words);
    for (const auto& [name, light] : lights_) statistics.materialBytes += core::allocatedBytes(name);
    return statistics;
}

}  // namespace gr
