#include "gr/accelerators/grid_walk.h"
#include "gr/accelerators/two_level_accelerator.h"
#include "gr/mesh/parts.h"

namespace gr {
namespace {

class GridAccelerator final : public TwoLevelAccelerator<Grid> {
public:
    // onlyEven: see Grid.
    GridAccelerator(const Scene& scene, Objects objects, int threads, bool onlyEven)
        : TwoLevelAccelerator(scene, objects, [=](std::uint32_t count, const BoundsOf& boundsOf, float errorPerUnit) {
              std::vector<core::Bounds> bounds(count);
              inParts(static_cast<int>(count), threads, [&](int first, int end) {
                  for (int i = first; i < end; ++i) bounds[i] = boundsOf(static_cast<std::uint32_t>(i));
              });
              return std::make_unique<Grid>(bounds, errorPerUnit, threads, 1, onlyEven);
          }) {}

    bool isEven(std::size_t objectCount) const { return meshes().empty() && objects().isEven(objectCount); }

    std::size_t bytes() const override {
        std::size_t bytes = objects().bytes();
        for (const auto& [polyhedron, grid] : meshes()) bytes += grid->bytes();
        return bytes;
    }

    std::string description() const override {
        const auto [x, y, z] = objects().resolution();
        std::string text =
            "grid of " + std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z) + " cells";
        if (objects().levelCount() > 1) text += ", " + std::to_string(objects().levelCount() - 1) + " in crowded cells";
        if (!meshes().empty()) text += ", " + std::to_string(meshes().size()) + " in meshes";
        return text;
    }

    std::optional<std::array<int, 3>> resolution() const override { return objects().resolution(); }
};

}  // namespace

std::unique_ptr<Accelerator> makeGridAccelerator(const Scene& scene, Objects objects, int threads) {
    // What would be one cell is tested four objects at once.
    constexpr std::size_t few = 32;
    if (scene.objectCount() <= few) return makeNoAccelerator(scene, objects);
    return std::make_unique<GridAccelerator>(scene, objects, threads, false);
}

std::unique_ptr<Accelerator> makeEvenGrid(const Scene& scene, Objects objects, int threads) {
    if (!scene.polyhedra.empty()) return nullptr;
    auto grid = std::make_unique<GridAccelerator>(scene, objects, threads, true);
    return grid->isEven(objects.size()) ? std::move(grid) : nullptr;
}

}  // namespace gr
