// A scene made ready for the path integrator.
#pragma once

#include "gr/scene.h"
#include "render/transport/light_choice.h"

#include <cstddef>

namespace render {

inline constexpr int mostLanes = 16;

struct PathScene {
    PathScene(const gr::Scene& scene, const gr::Accelerator& accelerator);

    const gr::Scene& scene;
    const gr::Accelerator& accelerator;
    bool hasInteriors = false;  // materials that paths go through
    bool hasAnisotropy = false;
    bool hasTextures = false;
    LightChoice lights;

    std::size_t bytes() const { return lights.bytes(); }
};

}  // namespace render
