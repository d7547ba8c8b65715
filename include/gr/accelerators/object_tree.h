// Instances in trees of boxes: one over them all, and one in each mesh, which all the mesh's instances share.
#pragma once

#include "gr/accelerators/object_pack.h"
#include "gr/accelerators/wide_tree.h"
#include "gr/scene.h"

#include <memory>
#include <unordered_map>

namespace gr {

// The trees in meshes, each made once.
class MeshTrees {
public:
    // device: as a WideTree has it; it must outlive this.
    explicit MeshTrees(const EmbreeDevice* device) : device_(device) {}

    void add(const Polyhedron& mesh, int threads);
    const WideTree& of(const Polyhedron& mesh) const { return *trees_.at(&mesh); }
    std::size_t count() const { return trees_.size(); }
    std::size_t bytes() const;  // of those that no device has built

private:
    const EmbreeDevice* device_;
    std::unordered_map<const Polyhedron*, std::unique_ptr<WideTree>> trees_;
};

class ObjectTree {
public:
    // objects: the instances that it is for, by their indices. device: as a WideTree has it. It and the meshes must
    // outlive this.
    ObjectTree(const Scene& scene, std::span<const std::uint32_t> objects, const EmbreeDevice* device,
               MeshTrees& meshes, int threads);

    const WideTree& objects() const { return *objects_; }
    // The mesh that is all there is, or null.
    const MeshPack* onlyMesh() const;

private:
    std::unique_ptr<WideTree> objects_;
};

}  // namespace gr
