#include "gr/accelerator.h"
#include "gr/scene.h"

namespace gr {
namespace {

// The report's linear search, and the oracle for every other accelerator.
class NoAccelerator final : public Accelerator {
public:
    explicit NoAccelerator(const Scene& scene) : instances_(scene.instances) {}

    std::optional<Hit> intersect(const core::Rayf& worldRay) const override {
        core::Rayf ray = worldRay;
        Hit nearest;
        for (std::size_t i = 0; i < instances_.size(); ++i) {
            const core::Rayf objectRay = instances_[i].toObject(ray);
            if (!std::visit([&](const auto& shape) { return hits(shape, objectRay, nearest); }, instances_[i].shape))
                continue;
            nearest.instance = static_cast<std::uint32_t>(i);
            ray.tMax = nearest.t;
        }
        if (nearest.t == core::infinity) return std::nullopt;
        return nearest;
    }

    bool occluded(const core::Rayf& ray) const override {
        for (const Instance& instance : instances_) {
            const core::Rayf objectRay = instance.toObject(ray);
            if (std::visit([&](const auto& shape) { return blocks(shape, objectRay); }, instance.shape)) return true;
        }
        return false;
    }

    std::size_t bytes() const override { return 0; }

private:
    static bool hits(const auto& shape, const core::Rayf& ray, Hit& hit) {
        const float t = shape.intersect(ray);
        if (t == core::infinity) return false;
        hit.t = t;
        return true;
    }
    static bool hits(const Polyhedron* polyhedron, const core::Rayf& ray, Hit& hit) {
        return polyhedron->intersect(ray, hit);
    }
    static bool blocks(const auto& shape, const core::Rayf& ray) { return shape.intersect(ray) != core::infinity; }
    static bool blocks(const Polyhedron* polyhedron, const core::Rayf& ray) { return polyhedron->occluded(ray); }

    const std::vector<Instance>& instances_;
};

}  // namespace

std::unique_ptr<Accelerator> makeNoAccelerator(const Scene& scene) {
    return std::make_unique<NoAccelerator>(scene);
}

}  // namespace gr
