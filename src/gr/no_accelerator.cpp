#include "gr/accelerator.h"
#include "gr/scene.h"
#include "gr/triangle_pack.h"

namespace gr {
namespace {

// The report's linear search, and the oracle for every other accelerator.
class NoAccelerator final : public Accelerator {
public:
    explicit NoAccelerator(const Scene& scene) : instances_(scene.instances) {}

    std::optional<Hit> intersect(const core::Rayf& ray) const override {
        WorldRay world{ray};
        Hit nearest;
        for (std::size_t i = 0; i < instances_.size(); ++i) {
            if (!std::visit([&](auto shape) { return hits(instances_[i], shape, world, nearest); },
                            instances_[i].shape))
                continue;
            nearest.instance = static_cast<std::uint32_t>(i);
            world.shortenTo(nearest.t);
        }
        if (nearest.t == core::infinity) return std::nullopt;
        return nearest;
    }

    bool occluded(const core::Rayf& ray) const override {
        const WorldRay world{ray};
        for (const Instance& instance : instances_)
            if (std::visit([&](auto shape) { return blocks(instance, shape, world); }, instance.shape)) return true;
        return false;
    }

    std::size_t bytes() const override { return 0; }

private:
    // A ray, made ready for triangles once for all polyhedra that stand in the world as they are.
    struct WorldRay {
        core::Rayf ray;
        PackRay packRay{ray};

        void shortenTo(float t) {
            ray.tMax = t;
            packRay.shortenTo(t);
        }
    };

    static bool hits(const Instance& instance, auto shape, const WorldRay& world, Hit& hit) {
        const float t = shape.intersect(instance.toObject(world.ray));
        if (t == core::infinity) return false;
        hit.t = t;
        return true;
    }
    static bool hits(const Instance& instance, const Polyhedron* polyhedron, WorldRay& world, Hit& hit) {
        if (instance.isInPlace) return polyhedron->intersect(world.packRay, hit);
        PackRay ray(instance.toObject(world.ray));
        return polyhedron->intersect(ray, hit);
    }
    static bool blocks(const Instance& instance, auto shape, const WorldRay& world) {
        return shape.intersect(instance.toObject(world.ray)) != core::infinity;
    }
    static bool blocks(const Instance& instance, const Polyhedron* polyhedron, const WorldRay& world) {
        if (instance.isInPlace) return polyhedron->occluded(world.packRay);
        return polyhedron->occluded(PackRay(instance.toObject(world.ray)));
    }

    const std::vector<Instance>& instances_;
};

}  // namespace

std::unique_ptr<Accelerator> makeNoAccelerator(const Scene& scene) {
    return std::make_unique<NoAccelerator>(scene);
}

}  // namespace gr
