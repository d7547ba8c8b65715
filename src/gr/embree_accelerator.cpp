#include "core/error.h"
#include "gr/embree_library.h"
#include "gr/embree_tree.h"
#include "gr/two_level_accelerator.h"

namespace gr {
namespace {

// A base class, for the trees need the device from first to last.
struct DeviceOwner {
    EmbreeDevice device;
};

// Embree's trees find which objects and triangles a ray comes near; where it meets them is computed by our own code.
class EmbreeAccelerator final : private DeviceOwner, public TwoLevelAccelerator<EmbreeTree> {
public:
    EmbreeAccelerator(const Scene& scene, int threads)
        : TwoLevelAccelerator(scene, [&](std::uint32_t count, BoundsOf boundsOf, float errorPerUnit) {
              return std::make_unique<EmbreeTree>(device, count, std::move(boundsOf), errorPerUnit, threads);
          }) {}

    std::size_t bytes() const override { return device.bytes(); }

    std::string description() const override {
        std::string text = "Embree tree";
        if (!meshes().empty()) text += ", " + std::to_string(meshes().size()) + " in meshes";
        return text;
    }
};

}  // namespace

bool isEmbreeInstalled() {
    try {
        EmbreeLibrary::get();
        return true;
    } catch (const core::Error&) {
        return false;
    }
}

std::unique_ptr<Accelerator> makeEmbreeAccelerator(const Scene& scene, int threads) {
    return std::make_unique<EmbreeAccelerator>(scene, threads);
}

}  // namespace gr
