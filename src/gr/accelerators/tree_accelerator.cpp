#include "gr/accelerators/tree_accelerator.h"

#include "core/error.h"
#include "gr/accelerators/tree_tracer.h"
#include "gr/embree_library.h"

#include <algorithm>
#include <cstring>

namespace gr {
namespace {

constexpr float unitRoundoff = 0x1p-24f;
constexpr float triangleErrorPerUnit = 64 * unitRoundoff;

core::Bounds boundsOf(const Polyhedron& mesh, std::uint32_t triangle) {
    core::Bounds bounds;
    for (int corner = 0; corner < 3; ++corner) bounds.include(mesh.vertex(triangle, corner));
    return bounds.widened(triangleErrorPerUnit * bounds.reach());
}

float largestErrorPerUnit(const Scene& scene) {
    float largest = 0;
    for (const Instance& instance : scene.instances) largest = std::max(largest, instance.errorPerUnit());
    return 2 * largest + 8 * unitRoundoff;
}

std::size_t bytesOfPack(const ObjectPack& pack) {
    std::size_t bytes = 0;
    visitPack(pack, [&](const auto& typed) { return bytes = sizeof(typed), false; });
    return bytes;
}

}  // namespace

TreeAccelerator::TreeAccelerator(const Scene& scene, int threads) : scene_(scene) {
    for (const auto& mesh : scene.polyhedra) addMesh(*mesh, threads);
    objects_ = std::make_unique<WideTree>(
        device_, static_cast<std::uint32_t>(scene.instances.size()),
        [&](std::uint32_t i) { return scene.instances[i].bounds(); },
        [&](Items items, const WideTree::Allocate& allocate) { return makeLeaf(items, allocate); },
        largestErrorPerUnit(scene), threads);
}

void TreeAccelerator::addMesh(const Polyhedron& mesh, int threads) {
    const auto leaf = [&](Items items, const WideTree::Allocate& allocate) {
        auto* leaf = static_cast<TriangleLeaf*>(std::memset(allocate(sizeof(TriangleLeaf)), 0, sizeof(TriangleLeaf)));
        for (std::size_t i = 0; i < items.size(); ++i) {
            leaf->triangles.set(static_cast<int>(i),
                                {mesh.vertex(items[i], 0), mesh.vertex(items[i], 1), mesh.vertex(items[i], 2)});
            leaf->triangle[i] = items[i];
        }
        return leaf;
    };
    meshes_[&mesh] = std::make_unique<WideTree>(
        device_, static_cast<std::uint32_t>(mesh.triangleCount()), [&](std::uint32_t i) { return boundsOf(mesh, i); },
        leaf, triangleErrorPerUnit, threads);
}

const void* TreeAccelerator::makeLeaf(Items items, const WideTree::Allocate& allocate) const {
    std::array<std::uint32_t, treeWidth> sorted;
    std::copy(items.begin(), items.end(), sorted.begin());
    const auto kind = [&](std::uint32_t i) { return kindOf(scene_.instances[i]); };
    std::sort(sorted.begin(), sorted.begin() + items.size(), [&](std::uint32_t a, std::uint32_t b) {
        return kind(a) != kind(b) ? kind(a) < kind(b) : a < b;
    });

    // What follows what, and where.
    std::array<ObjectPack, treeWidth> packs{};
    std::size_t count = 0, bytes = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (count == 0 || packs[count - 1].kind != kind(sorted[i])) packs[count++].kind = kind(sorted[i]);
        ObjectPack& pack = packs[count - 1];
        pack.instance[pack.count++] = sorted[i];
    }
    for (std::size_t i = 0; i < count; ++i) {
        std::fill(packs[i].instance + packs[i].count, packs[i].instance + treeWidth, packs[i].instance[packs[i].count - 1]);
        packs[i].bytesToNext = static_cast<std::uint32_t>(bytesOfPack(packs[i]));
        bytes += packs[i].bytesToNext;
    }
    packs[count - 1].bytesToNext = 0;

    char* const leaf = static_cast<char*>(allocate(bytes));
    char* place = leaf;
    for (std::size_t i = 0; i < count; ++i) {
        auto* pack = reinterpret_cast<ObjectPack*>(place);
        *pack = packs[i];
        visitPack(*pack, [&](auto& typed) { return fill(typed), false; });
        place += pack->bytesToNext;
    }
    return leaf;
}

void TreeAccelerator::fill(MeshPack& pack) const {
    for (std::uint32_t i = 0; i < pack.count; ++i)
        pack.tree[i] = meshes_.at(std::get<const Polyhedron*>(scene_.instances[pack.instance[i]].shape)).get();
}

template<class S>
void TreeAccelerator::fill(ShapePack<S, AlignedMapOf>& pack) const {
    for (int i = 0; i < treeWidth; ++i)
        pack.set(static_cast<int>(i), placeOf(pack, i).alignedObjectFromWorld());
}
template<class S>
void TreeAccelerator::fill(ShapePack<S, core::AffineMap>& pack) const {
    for (std::uint32_t i = 0; i < treeWidth; ++i) pack.set(static_cast<int>(i), placeOf(pack, i).objectFromWorld());
}

const Placement& TreeAccelerator::placeOf(const ObjectPack& pack, std::uint32_t i) const {
    return scene_.instances[pack.instance[i]].place;
}

std::optional<Hit> TreeAccelerator::intersect(const core::Rayf& ray, TraversalCounts& counts) const {
    Hit nearest;
    nearest.t = ray.tMax;
    nearest.instance = ~0u;
    TreeTracer<PackLanes>(*this, counts).nearest(ray, nearest);
    if (nearest.instance == ~0u) return std::nullopt;
    return nearest;
}

bool TreeAccelerator::occluded(const core::Rayf& ray, TraversalCounts& counts) const {
    return TreeTracer<PackLanes>(*this, counts).occluded(ray);
}

std::string TreeAccelerator::description() const {
    std::string text = "Embree tree";
    if (!meshes_.empty()) text += ", " + std::to_string(meshes_.size()) + " in meshes";
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

std::unique_ptr<Accelerator> makeEmbreeAccelerator(const Scene& scene, int threads) {
    return std::make_unique<TreeAccelerator>(scene, threads);
}

}  // namespace gr
