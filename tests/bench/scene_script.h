// The scene of a script, and the camera of its first picture, without that being rendered.
#pragma once

#include "gr/scene.h"
#include "render/transport/camera.h"

#include <string>

namespace bench {

struct ScriptScene {
    gr::Scene scene;
    render::Camera camera;
    int width, height;  // pixels
};

// Throws std::runtime_error where the script fails, or renders nothing.
ScriptScene sceneOf(const std::string& script);

}  // namespace bench
