// The scene in trees of boxes: one over its objects, and one in each mesh, which all the mesh's instances share.
#pragma once

#include "gr/accelerators/accelerator.h"
#include "gr/accelerators/object_pack.h"
#include "gr/accelerators/wide_tree.h"
#include "gr/scene.h"

#include <unordered_map>

namespace gr {

class TreeAccelerator final : public Accelerator {
public:
    using Items = std::span<const std::uint32_t>;

    // objects: the instances that it is for, by their indices.
    TreeAccelerator(const Scene& scene, Items objects, int threads);

    std::optional<Hit> intersect(const core::Rayf& ray, TraversalCounts& counts) const override;
    bool occluded(const core::Rayf& ray, TraversalCounts& counts) const override;
    std::size_t bytes() const override { return device_.bytes(); }
    std::string description() const override;
    const TreeAccelerator* tree() const override { return this; }

    const Scene& scene() const { return scene_; }
    const WideTree& objects() const { return *objects_; }
    // The mesh that is all there is, or null.
    const MeshPack* onlyMesh() const;

private:
    void addMesh(const Polyhedron& mesh, int threads);
    TreeReference makeLeaf(Items items, Items objects, const WideTree::Allocate& allocate) const;
    TreeReference makePack(Items instances, const WideTree::Allocate& allocate) const;
    void fill(MeshPack& pack) const;
    template<class S>
    void fill(ShapePack<S, AlignedMapOf>& pack) const;
    template<class S>
    void fill(ShapePack<S, core::AffineMap>& pack) const;
    const Instance& instanceOf(const ObjectPack& pack, std::uint32_t i) const;

    const Scene& scene_;
    EmbreeDevice device_;
    std::unordered_map<const Polyhedron*, std::unique_ptr<WideTree>> meshes_;
    std::unique_ptr<WideTree> objects_;
};

}  // namespace gr
