#include "gr/accelerators/tree_accelerator.h"

#include "core/error.h"
#include "gr/accelerators/embree_library.h"
#include "gr/accelerators/tree_tracer.h"

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

}  // namespace

TreeAccelerator::TreeAccelerator(const Scene& scene, Items objects, int threads) : scene_(scene) {
    for (const std::uint32_t i : objects) {
        const auto* mesh = std::get_if<const Polyhedron*>(&scene.instances[i].shape);
        if (mesh != nullptr && !meshes_.contains(*mesh)) addMesh(**mesh, threads);
    }
    objects_ = std::make_unique<WideTree>(
        device_, static_cast<std::uint32_t>(objects.size()),
        [&](std::uint32_t i) { return scene.instances[objects[i]].bounds(); },
        [&](Items items, const WideTree::Allocate& allocate) { return makeLeaf(items, objects, allocate); },
        largestErrorPerUnit(scene), threads);
}

void TreeAccelerator::addMesh(const Polyhedron& mesh, int threads) {
    const auto leaf = [&](Items items, const WideTree::Allocate& allocate) -> TreeReference {
        auto* leaf = static_cast<TriangleLeaf*>(std::memset(allocate(sizeof(TriangleLeaf)), 0, sizeof(TriangleLeaf)));
        for (std::size_t i = 0; i < items.size(); ++i) {
            leaf->triangles.set(static_cast<int>(i),
                                {mesh.vertex(items[i], 0), mesh.vertex(items[i], 1), mesh.vertex(items[i], 2)});
            leaf->triangle[i] = items[i];
        }
        return {leaf, TreeReference::leaf};
    };
    meshes_[&mesh] = std::make_unique<WideTree>(
        device_, static_cast<std::uint32_t>(mesh.triangleCount()), [&](std::uint32_t i) { return boundsOf(mesh, i); },
        leaf, triangleErrorPerUnit, threads);
}

// items: places in `objects`. Objects of a kind make a pack; a mesh is one by itself.
TreeReference TreeAccelerator::makeLeaf(Items items, Items objects, const WideTree::Allocate& allocate) const {
    std::vector<std::uint32_t> sorted(items.size());
    std::transform(items.begin(), items.end(), sorted.begin(), [&](std::uint32_t i) { return objects[i]; });
    const auto kind = [&](std::uint32_t i) { return scene_.instances[i].shape.index(); };
    std::sort(sorted.begin(), sorted.end(),
              [&](std::uint32_t a, std::uint32_t b) { return kind(a) != kind(b) ? kind(a) < kind(b) : a < b; });
    std::array<TreeReference, treeWidth> packs;
    std::array<core::Bounds, treeWidth> bounds;
    int count = 0;
    for (std::size_t i = 0; i < items.size(); ++count) {
        std::size_t end = i + 1;
        while (kind(sorted[i]) != 0 && end < items.size() && kind(sorted[end]) == kind(sorted[i])) ++end;
        packs[count] = makePack({&sorted[i], end - i}, allocate);
        for (; i < end; ++i) bounds[count].include(scene_.instances[sorted[i]].bounds());
    }
    if (count == 1) return packs[0];
    auto* node = static_cast<TreeNode*>(allocate(sizeof(TreeNode)));
    node->clear();
    for (int i = 0; i < count; ++i) node->set(i, bounds[i], packs[i]);
    return {node, TreeReference::node};
}

// Of instances of a kind.
TreeReference TreeAccelerator::makePack(Items instances, const WideTree::Allocate& allocate) const {
    const auto isGeneral = [&](std::uint32_t i) { return scene_.instances[i].place.isGeneral(); };
    const bool anyIsGeneral = std::any_of(instances.begin(), instances.end(), isGeneral);
    ObjectPack header{
        packKind(scene_.instances[instances[0]].shape, anyIsGeneral), static_cast<std::uint32_t>(instances.size()), {}};
    for (std::size_t i = 0; i < treeWidth; ++i) header.instance[i] = instances[std::min(i, instances.size() - 1)];
    ObjectPack* made = nullptr;
    visitPack(header, [&]<class Pack>(Pack&) {
        auto* pack = new (allocate(sizeof(Pack))) Pack;
        static_cast<ObjectPack&>(*pack) = header;
        fill(*pack);
        made = pack;
        return true;
    });
    return {made, TreeReference::leaf};
}

void TreeAccelerator::fill(MeshPack& pack) const {
    const Instance& instance = scene_.instances[pack.instance[0]];
    pack.tree = meshes_.at(std::get<const Polyhedron*>(instance.shape)).get();
    pack.place = instance.place;
}

template<class S>
void TreeAccelerator::fill(ShapePack<S, AlignedMapOf>& pack) const {
    for (std::uint32_t i = 0; i < treeWidth; ++i)
        pack.set(i, instanceOf(pack, i).place.alignedObjectFromWorld(), std::get<S>(instanceOf(pack, i).shape));
}
template<class S>
void TreeAccelerator::fill(ShapePack<S, core::AffineMap>& pack) const {
    for (std::uint32_t i = 0; i < treeWidth; ++i)
        pack.set(i, instanceOf(pack, i).place.objectFromWorld(), std::get<S>(instanceOf(pack, i).shape));
}

const Instance& TreeAccelerator::instanceOf(const ObjectPack& pack, std::uint32_t i) const {
    return scene_.instances[pack.instance[i]];
}

const MeshPack* TreeAccelerator::onlyMesh() const {
    const TreeReference root = objects_->root();
    const MeshPack* mesh = nullptr;
    if (root.isLeaf() && root.address() != nullptr)
        visitPack(*static_cast<const ObjectPack*>(root.address()), [&]<class Pack>(const Pack& pack) {
            if constexpr (std::is_same_v<Pack, MeshPack>) mesh = &pack;
            return true;
        });
    return mesh;
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

std::unique_ptr<Accelerator> makeEmbreeAccelerator(const Scene& scene, Objects objects, int threads) {
    return std::make_unique<TreeAccelerator>(scene, objects, threads);
}

}  // namespace gr
