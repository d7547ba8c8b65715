#include "gr/accelerator.h"
#include "gr/grid.h"
#include "gr/pack.h"
#include "gr/scene.h"

#include <algorithm>
#include <unordered_map>

namespace gr {
namespace {

constexpr float unitRoundoff = 0x1p-24f;

std::vector<core::Bounds> instanceBounds(const Scene& scene) {
    std::vector<core::Bounds> bounds;
    bounds.reserve(scene.instances.size());
    for (const Instance& instance : scene.instances) bounds.push_back(instance.bounds());
    return bounds;
}

float largestErrorPerUnit(const Scene& scene) {
    float largest = 0;
    for (const Instance& instance : scene.instances) largest = std::max(largest, instance.errorPerUnit);
    return 2 * largest + 8 * unitRoundoff;
}

Grid gridOf(const Polyhedron& polyhedron, int threads) {
    constexpr float errorPerUnit = 64 * unitRoundoff;
    std::vector<core::Bounds> bounds(polyhedron.triangleCount());
    for (std::uint32_t i = 0; i < bounds.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) bounds[i].include(polyhedron.vertex(i, corner));
        bounds[i] = bounds[i].widened(errorPerUnit * bounds[i].reach());
    }
    return Grid(bounds, errorPerUnit, threads);
}

// The report's two levels (section 5.3): a grid over the whole scene, and one for each polyhedron that is large enough
// to want its own, which all its instances share.
class GridAccelerator final : public Accelerator {
public:
    GridAccelerator(const Scene& scene, int threads)
        : scene_(scene), grid_(instanceBounds(scene), largestErrorPerUnit(scene), threads) {
        for (const auto& polyhedron : scene.polyhedra)
            if (polyhedron->triangleCount() > mostTrianglesWithoutGrid)
                meshGrids_.emplace(polyhedron.get(), gridOf(*polyhedron, threads));
    }

    std::optional<Hit> intersect(const core::Rayf& ray, TraversalCounts& counts) const override {
        Hit nearest;
        float reach = ray.tMax;
        grid_.walk(ray, reach, counts, [&](std::uint32_t i) {
            ++counts.tests;
            const Instance& instance = scene_.instances[i];
            const core::Rayf objectRay = instance.toObject(ray);
            const auto test = [&](const auto& shape) { intersectShape(shape, objectRay, i, nearest, reach, counts); };
            std::visit(test, instance.shape);
            return false;
        });
        if (nearest.t == core::infinity) return std::nullopt;
        return nearest;
    }

    bool occluded(const core::Rayf& ray, TraversalCounts& counts) const override {
        bool isMet = false;
        grid_.walk(ray, ray.tMax, counts, [&](std::uint32_t i) {
            ++counts.tests;
            const Instance& instance = scene_.instances[i];
            const core::Rayf objectRay = instance.toObject(ray);
            const auto test = [&](const auto& shape) { return isHit(shape, objectRay, counts); };
            isMet = std::visit(test, instance.shape);
            return isMet;
        });
        return isMet;
    }

    std::size_t bytes() const override {
        std::size_t bytes = grid_.bytes();
        for (const auto& [polyhedron, grid] : meshGrids_) bytes += grid.bytes();
        return bytes;
    }

    std::string description() const override {
        const auto [x, y, z] = grid_.resolution();
        std::string text =
            "grid of " + std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z) + " cells";
        if (!meshGrids_.empty()) text += ", " + std::to_string(meshGrids_.size()) + " in meshes";
        return text;
    }

private:
    static constexpr std::size_t mostTrianglesWithoutGrid = 16;

    template<class S>
    static void intersectShape(const S& shape, const core::Rayf& ray, std::uint32_t instance, Hit& nearest,
                               float& reach, TraversalCounts&) {
        offer({shape.intersect(ray), instance}, nearest, reach);
    }
    void intersectShape(const Polyhedron* polyhedron, const core::Rayf& ray, std::uint32_t instance, Hit& nearest,
                        float& reach, TraversalCounts& counts) const {
        const auto grid = meshGrids_.find(polyhedron);
        if (grid == meshGrids_.end()) {
            polyhedron->intersect(PackRay(ray), instance, nearest);
            reach = std::min(reach, nearest.t);
            return;
        }
        const TriangleRay<float> triangleRay(ray);
        grid->second.walk(ray, reach, counts, [&](std::uint32_t triangle) {
            ++counts.tests;
            const TriangleHit<float> found = polyhedron->intersect(triangleRay, triangle);
            offer({found.t, instance, triangle, found.b1, found.b2}, nearest, reach);
            return false;
        });
    }

    static void offer(const Hit& hit, Hit& nearest, float& reach) {
        if (!hit.isBefore(nearest)) return;
        nearest = hit;
        reach = hit.t;
    }

    template<class S>
    static bool isHit(const S& shape, const core::Rayf& ray, TraversalCounts&) {
        return shape.intersect(ray) < core::infinity;
    }
    bool isHit(const Polyhedron* polyhedron, const core::Rayf& ray, TraversalCounts& counts) const {
        const auto grid = meshGrids_.find(polyhedron);
        if (grid == meshGrids_.end()) return polyhedron->occluded(PackRay(ray));
        const TriangleRay<float> triangleRay(ray);
        bool isMet = false;
        grid->second.walk(ray, ray.tMax, counts, [&](std::uint32_t triangle) {
            ++counts.tests;
            isMet = polyhedron->intersect(triangleRay, triangle).t < core::infinity;
            return isMet;
        });
        return isMet;
    }

    const Scene& scene_;
    Grid grid_;
    std::unordered_map<const Polyhedron*, Grid> meshGrids_;
};

}  // namespace

std::unique_ptr<Accelerator> makeGridAccelerator(const Scene& scene, int threads) {
    // What would be one cell is tested four objects at once.
    std::size_t objects = scene.instances.size();
    for (const auto& polyhedron : scene.polyhedra) objects += polyhedron->triangleCount();
    constexpr std::size_t few = 32;
    if (objects <= few) return makeNoAccelerator(scene);
    return std::make_unique<GridAccelerator>(scene, threads);
}

}  // namespace gr
