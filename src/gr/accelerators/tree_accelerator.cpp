#include "gr/accelerators/tree_accelerator.h"

#include "core/error.h"
#include "gr/accelerators/embree_library.h"
#include "gr/accelerators/tree_tracer.h"

namespace gr {

std::optional<Hit> TreeAccelerator::intersect(const core::Rayf& ray, TraversalCounts& counts) const {
    Hit nearest;
    nearest.t = ray.tMax;
    nearest.instance = ~0u;
    TreeTracer<PackLanes>(scene_, objects_, counts).nearest(ray, nearest);
    if (nearest.instance == ~0u) return std::nullopt;
    return nearest;
}

bool TreeAccelerator::occluded(const core::Rayf& ray, TraversalCounts& counts) const {
    return TreeTracer<PackLanes>(scene_, objects_, counts).occluded(ray);
}

std::string TreeAccelerator::description() const {
    std::string text = "Embree tree";
    if (meshes_.count() > 0) text += ", " + std::to_string(meshes_.count()) + " in meshes";
    return text;
}

bool isEmbreeInstalled() {
    try {
        EmbreeLibrary::get();
        return true;
    } catch (const core::Error&) {
        return false;
    }
}

std::unique_ptr<Accelerator> makeEmbreeAccelerator(const Scene& scene, Objects objects, int threads) {
    return std::make_unique<TreeAccelerator>(scene, objects, threads);
}

}  // namespace gr
