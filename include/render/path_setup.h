// What the path integrator is given, whatever number of lanes it has.
#pragma once

#include "render/eye_media.h"
#include "render/integrator.h"
#include "render/path_scene.h"

namespace render {

struct PathSetup {
    PathScene scene;
    int pathLength;
    int lightSamples;  // of each light that has places to draw, at each surface point, but where
    bool picksLights;  // chance picks which light a sample asks: then of all lights together
    core::Rgbf background, ambient;
    EyeMedia eyeMedia;
};

}  // namespace render

// The same integrator, compiled for processors that have less or more: each gives the same picture, bit by bit. The
// caller owns what it returns. C names, which the build keeps while it hides all else of the wider ones.
extern "C" {
render::Integrator* grsh_path_integrator_float(render::PathSetup&& setup);
render::Integrator* grsh_path_integrator_baseline(render::PathSetup&& setup);
render::Integrator* grsh_path_integrator_avx2(render::PathSetup&& setup);
render::Integrator* grsh_path_integrator_avx512(render::PathSetup&& setup);
}
