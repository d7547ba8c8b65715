#include "render/transport/path_scene.h"

namespace render {

PathScene::PathScene(const gr::Scene& scene, const gr::Accelerator& accelerator)
    : scene(scene),
      accelerator(accelerator),
      hasInteriors(scene.hasInteriors()),
      hasTextures(scene.hasTextures()),
      lights(scene.lights) {
    for (const materials::Material& material : scene.materials) {
        hasAnisotropy |= std::visit([](const auto& m) { return m.isAnisotropic(); }, material);
    }
}

}  // namespace render
