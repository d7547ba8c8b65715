#include "gr/accelerators/accelerator.h"
#include "gr/accelerators/object_pack.h"
#include "gr/csg/csg_tracer.h"
#include "gr/mesh/pack.h"
#include "gr/scene.h"

#include <tuple>

namespace gr {
namespace {

// For each shape, its instances in packs.
template<class Shape>
using PackOf = ShapePack<Shape, core::AffineMap>;
template<class>
struct PacksOf;
template<class... Shapes>
struct PacksOf<std::variant<const Polyhedron*, const Csg*, Shapes...>> {
    using Type = std::tuple<std::vector<PackOf<Shapes>>...>;
};

// Calls f(t, first) for the packs' places, four at a time: their t, and the first place.
template<class Pack, class F>
void forEachFour(const core::Ray<PackLanes>& ray, const Pack& pack, F&& f) {
    for (int first = 0; first < static_cast<int>(pack.count); first += packWidth)
        f(pack.template intersect<PackLanes>(ray, first), first);
}

// The report's linear search, and the oracle for every other accelerator: every ray is tested against every object,
// four of a kind at once.
class NoAccelerator final : public Accelerator {
public:
    NoAccelerator(const Scene& scene, Objects objects) : scene_(scene) {
        for (const std::uint32_t i : objects)
            std::visit([&](const auto& shape) { add(i, shape); }, scene.instances[i].shape);
    }

    std::optional<Hit> intersect(const core::Rayf& ray, TraversalCounts& counts) const override {
        counts.tests += objects_;
        Hit nearest;
        const PackRay packRay(ray);
        for (const MeshPack& pack : smallMeshes_)
            pack.triangles.intersect(packRay, [&](const TriangleHit<PackLanes>& found) {
                if (!xsimd::any(found.t <= PackLanes(nearest.t))) return;
                const LaneValues t(found.t), b1(found.b1), b2(found.b2);
                for (int lane = 0; lane < packWidth; ++lane) {
                    const Hit hit{t[lane], pack.instance[lane], pack.triangle[lane], b1[lane], b2[lane]};
                    if (hit.isBefore(nearest)) nearest = hit;
                }
            });
        const core::Ray<PackLanes> lanesRay = broadcast(ray);
        forEachPack([&](const auto& pack) {
            forEachFour(lanesRay, pack, [&](const PackLanes& found, int first) {
                if (!xsimd::any(found <= PackLanes(nearest.t))) return;
                const LaneValues t(found);
                for (int lane = 0; lane < packWidth; ++lane) {
                    const Hit hit{t[lane], pack.instance[first + lane]};
                    if (hit.isBefore(nearest)) nearest = hit;
                }
            });
            return false;
        });
        for (const std::uint32_t i : polyhedra_)
            polyhedronOf(i).intersect(PackRay(scene_.instances[i].place.toObject(ray)), i, nearest);
        for (const Csg* csg : csgs_) CsgTracer<PackLanes>(scene_, *csg, counts).nearest(ray, nearest);
        if (nearest.t == core::infinity) return std::nullopt;
        return nearest;
    }

    bool occluded(const core::Rayf& ray, TraversalCounts& counts) const override {
        counts.tests += objects_;
        const PackLanes never(core::infinity);
        // Bodies first: they stand in the way more often than walls, which are meshes.
        const core::Ray<PackLanes> lanesRay = broadcast(ray);
        bool isMet = forEachPack([&](const auto& pack) {
            bool isAnyMet = false;
            forEachFour(lanesRay, pack,
                        [&](const PackLanes& found, int) { isAnyMet = isAnyMet || xsimd::any(found < never); });
            return isAnyMet;
        });
        if (isMet) return true;
        const PackRay packRay(ray);
        for (std::size_t i = 0; i < smallMeshes_.size() && !isMet; ++i)
            smallMeshes_[i].triangles.intersect(
                packRay, [&](const TriangleHit<PackLanes>& found) { isMet = xsimd::any(found.t < never); });
        for (std::size_t i = 0; i < polyhedra_.size() && !isMet; ++i)
            isMet = polyhedronOf(polyhedra_[i]).occluded(PackRay(scene_.instances[polyhedra_[i]].place.toObject(ray)));
        for (std::size_t i = 0; i < csgs_.size() && !isMet; ++i)
            isMet = CsgTracer<PackLanes>(scene_, *csgs_[i], counts).occluded(ray);
        return isMet;
    }

    std::size_t bytes() const override {
        std::size_t bytes = smallMeshes_.capacity() * sizeof(MeshPack) + polyhedra_.capacity() * sizeof(std::uint32_t) +
                            csgs_.capacity() * sizeof(const Csg*);
        const auto add = [&]<class Pack>(const std::vector<Pack>& packs) { bytes += packs.capacity() * sizeof(Pack); };
        std::apply([&](const auto&... packs) { (add(packs), ...); }, packs_);
        return bytes;
    }

    std::string description() const override { return "every object tested"; }
    bool testsAll() const override { return true; }

private:
    // Triangles of meshes that stand in the world as they are, several meshes' in a pack.
    struct MeshPack {
        TrianglePack triangles{};
        std::uint32_t instance[packWidth] = {};
        std::uint32_t triangle[packWidth] = {};
    };
    // A larger mesh fills its own packs well enough to be left where it is.
    static constexpr std::size_t mostTrianglesOfSmallMesh = 64;

    const Polyhedron& polyhedronOf(std::uint32_t instance) const {
        return *std::get<const Polyhedron*>(scene_.instances[instance].shape);
    }

    // Calls function(pack) for each pack of instances until one call returns true, and returns whether one did.
    bool forEachPack(auto&& function) const {
        const auto inOneList = [&](const auto& packs) {
            for (const auto& pack : packs)
                if (function(pack)) return true;
            return false;
        };
        return std::apply([&](const auto&... packs) { return (inOneList(packs) || ...); }, packs_);
    }

    template<class Shape>
    void add(std::uint32_t instance, const Shape& shape) {
        ++objects_;
        auto& packs = std::get<std::vector<PackOf<Shape>>>(packs_);
        if (packs.empty() || packs.back().count == treeWidth) packs.emplace_back();
        PackOf<Shape>& pack = packs.back();
        // The places behind are overwritten by the next ones; until then they repeat this one.
        for (std::size_t place = pack.count++; place < treeWidth; ++place) {
            pack.instance[place] = instance;
            pack.set(place, scene_.instances[instance].place.objectFromWorld(), shape);
        }
    }

    void add(std::uint32_t instance, const Polyhedron* polyhedron) {
        objects_ += polyhedron->triangleCount();
        if (!scene_.instances[instance].place.isInPlace() || polyhedron->triangleCount() > mostTrianglesOfSmallMesh) {
            polyhedra_.push_back(instance);
            return;
        }
        for (std::uint32_t i = 0; i < polyhedron->triangleCount(); ++i, ++smallTriangles_) {
            const int lane = static_cast<int>(smallTriangles_ % packWidth);
            if (lane == 0) smallMeshes_.emplace_back();
            MeshPack& pack = smallMeshes_.back();
            pack.triangles.set(lane, {polyhedron->vertex(i, 0), polyhedron->vertex(i, 1), polyhedron->vertex(i, 2)});
            pack.instance[lane] = instance;
            pack.triangle[lane] = i;
        }
    }

    void add(std::uint32_t, const Csg* csg) { csgs_.push_back(csg); }

    const Scene& scene_;
    std::uint64_t objects_ = 0;  // shapes and triangles
    std::vector<MeshPack> smallMeshes_;
    std::size_t smallTriangles_ = 0;
    typename PacksOf<Shape>::Type packs_;
    std::vector<std::uint32_t> polyhedra_;  // the other meshes
    std::vector<const Csg*> csgs_;
};

}  // namespace

std::unique_ptr<Accelerator> makeNoAccelerator(const Scene& scene, Objects objects) {
    return std::make_unique<NoAccelerator>(scene, objects);
}

}  // namespace gr
