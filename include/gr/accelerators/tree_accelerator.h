// A scene in trees of boxes that Embree builds.
#pragma once

#include "gr/accelerators/accelerator.h"
#include "gr/accelerators/object_tree.h"

namespace gr {

class TreeAccelerator final : public Accelerator {
public:
    // objects: the instances that it is for, by their indices.
    TreeAccelerator(const Scene& scene, Objects objects, int threads)
        : scene_(scene), meshes_(&device_), objects_(scene, objects, &device_, meshes_, threads) {}

    std::optional<Hit> intersect(const core::Rayf& ray, TraversalCounts& counts) const override;
    bool occluded(const core::Rayf& ray, TraversalCounts& counts) const override;
    std::size_t bytes() const override { return device_.bytes(); }
    std::string description() const override;
    const ObjectTree* tree() const override { return &objects_; }

private:
    const Scene& scene_;
    EmbreeDevice device_;
    MeshTrees meshes_;
    ObjectTree objects_;
};

}  // namespace gr
