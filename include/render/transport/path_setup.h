// What the path integrator is given, whatever number of lanes it has.
#pragma once

#include "core/vec.h"
#include "render/transport/eye_media.h"
#include "render/transport/integrator.h"
#include "render/transport/path_scene.h"

namespace render {

struct PathSetup {
    PathScene scene;
    int pathLength;
    // The light samples at each surface point. Where chance picks the light that a sample asks, so many are drawn in
    // all; else so many of each light that has places to draw, and one of each other light.
    int lightSamples;
    bool picksLights;  // whether chance does
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
