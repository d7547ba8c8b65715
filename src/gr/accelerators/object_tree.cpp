#include "gr/accelerators/object_tree.h"

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

float largestErrorPerUnit(const Scene& scene, std::span<const std::uint32_t> objects) {
    float largest = 0;
    for (const std::uint32_t i : objects) {
        const Instance& instance = scene.instances[i];
        largest = std::max(largest, instance.errorPerUnit());
        // What is met of a CSG object is one of its operands.
        if (const auto* csg = std::get_if<const Csg*>(&instance.shape))
            for (std::uint32_t k = 0; k < (*csg)->operandCount(); ++k)
                largest = std::max(largest, scene.instances[(*csg)->firstOperand() + k].errorPerUnit());
    }
    return 2 * largest + 8 * unitRoundoff;
}

// What makes the leaves of a tree over instances.
class LeafMaker {
public:
    using Items = std::span<const std::uint32_t>;

    LeafMaker(const Scene& scene, Items objects, const MeshTrees& meshes)
        : scene_(scene), objects_(objects), meshes_(meshes) {}

    // items: places in objects_. Objects of a kind make a pack; a mesh is one by itself, and so is a CSG object.
    TreeReference makeLeaf(Items items, const WideTree::Allocate& allocate) const {
        std::vector<std::uint32_t> sorted(items.size());
        std::transform(items.begin(), items.end(), sorted.begin(), [&](std::uint32_t i) { return objects_[i]; });
        const auto kind = [&](std::uint32_t i) { return scene_.instances[i].shape.index(); };
        std::sort(sorted.begin(), sorted.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return kind(a) != kind(b) ? kind(a) < kind(b) : a < b; });
        std::array<TreeReference, treeWidth> packs;
        std::array<core::Bounds, treeWidth> bounds;
        int count = 0;
        for (std::size_t i = 0; i < items.size(); ++count) {
            std::size_t end = i + 1;
            while (!isOneByOne(scene_.instances[sorted[i]].shape) && end < items.size() &&
                   kind(sorted[end]) == kind(sorted[i]))
                ++end;
            packs[count] = makePack({&sorted[i], end - i}, allocate);
            for (; i < end; ++i) bounds[count].include(scene_.instances[sorted[i]].bounds());
        }
        if (count == 1) return packs[0];
        auto* node = static_cast<TreeNode*>(allocate(sizeof(TreeNode)));
        node->clear();
        for (int i = 0; i < count; ++i) node->set(i, bounds[i], packs[i]);
        return {node, TreeReference::node};
    }

private:
    // Of instances of a kind.
    TreeReference makePack(Items instances, const WideTree::Allocate& allocate) const {
        const auto isGeneral = [&](std::uint32_t i) { return scene_.instances[i].place.isGeneral(); };
        const bool anyIsGeneral = std::any_of(instances.begin(), instances.end(), isGeneral);
        ObjectPack header{packKind(scene_.instances[instances[0]].shape, anyIsGeneral),
                          static_cast<std::uint32_t>(instances.size()),
                          {}};
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

    void fill(MeshPack& pack) const {
        const Instance& instance = scene_.instances[pack.instance[0]];
        pack.tree = &meshes_.of(*std::get<const Polyhedron*>(instance.shape));
        pack.place = instance.place;
    }

    void fill(CsgPack& pack) const { pack.csg = std::get<const Csg*>(scene_.instances[pack.instance[0]].shape); }

    template<class S>
    void fill(ShapePack<S, AlignedMapOf>& pack) const {
        for (std::uint32_t i = 0; i < treeWidth; ++i)
            pack.set(i, instanceOf(pack, i).place.alignedObjectFromWorld(), std::get<S>(instanceOf(pack, i).shape));
    }
    template<class S>
    void fill(ShapePack<S, core::AffineMap>& pack) const {
        for (std::uint32_t i = 0; i < treeWidth; ++i)
            pack.set(i, instanceOf(pack, i).place.objectFromWorld(), std::get<S>(instanceOf(pack, i).shape));
    }

    const Instance& instanceOf(const ObjectPack& pack, std::uint32_t i) const {
        return scene_.instances[pack.instance[i]];
    }

    const Scene& scene_;
    const Items objects_;
    const MeshTrees& meshes_;
};

}  // namespace

void MeshTrees::add(const Polyhedron& mesh, int threads) {
    if (trees_.contains(&mesh)) return;
    const auto leaf = [&](std::span<const std::uint32_t> items, const WideTree::Allocate& allocate) -> TreeReference {
        auto* leaf = static_cast<TriangleLeaf*>(std::memset(allocate(sizeof(TriangleLeaf)), 0, sizeof(TriangleLeaf)));
        for (std::size_t i = 0; i < items.size(); ++i) {
            leaf->triangles.set(static_cast<int>(i),
                                {mesh.vertex(items[i], 0), mesh.vertex(items[i], 1), mesh.vertex(items[i], 2)});
            leaf->triangle[i] = items[i];
        }
        return {leaf, TreeReference::leaf};
    };
    trees_[&mesh] = std::make_unique<WideTree>(
        device_, static_cast<std::uint32_t>(mesh.triangleCount()), [&](std::uint32_t i) { return boundsOf(mesh, i); },
        leaf, triangleErrorPerUnit, threads);
}

std::size_t MeshTrees::bytes() const {
    std::size_t bytes = 0;
    for (const auto& [mesh, tree] : trees_) bytes += tree->bytes();
    return bytes;
}

ObjectTree::ObjectTree(const Scene& scene, std::span<const std::uint32_t> objects, const EmbreeDevice* device,
                       MeshTrees& meshes, int threads) {
    for (const std::uint32_t i : objects)
        if (const auto* mesh = std::get_if<const Polyhedron*>(&scene.instances[i].shape)) meshes.add(**mesh, threads);
    const LeafMaker leaves(scene, objects, meshes);
    objects_ = std::make_unique<WideTree>(
        device, static_cast<std::uint32_t>(objects.size()),
        [&](std::uint32_t i) { return scene.instances[objects[i]].bounds(); },
        [&](std::span<const std::uint32_t> items, const WideTree::Allocate& allocate) {
            return leaves.makeLeaf(items, allocate);
        },
        largestErrorPerUnit(scene, objects), threads);
}

const MeshPack* ObjectTree::onlyMesh() const {
    const TreeReference root = objects_->root();
    const MeshPack* mesh = nullptr;
    if (root.isLeaf() && root.address() != nullptr)
        visitPack(*static_cast<const ObjectPack*>(root.address()), [&]<class Pack>(const Pack& pack) {
            if constexpr (std::is_same_v<Pack, MeshPack>) mesh = &pack;
            return true;
        });
    return mesh;
}

}  // namespace gr
