// The render options: one row each. To add one: a member with its default, and a row.
#pragma once

#include "core/option.h"

namespace render {

struct RenderSettings {
    core::Word accelerator = "off";
    bool globalIllumination = false;
    bool antialiasing = false;
    int pathLength = 2;
    bool depthOfField = false;
    double focalDistance = 1;  // along the view
    double aperture = 0.1;  // the lens' radius
    std::optional<int> startLine;  // 0 is the top; both lines are rendered
    std::optional<int> stopLine;
    int samplesPerPixel = 16;
    int samplesPerLightSource = 1;
    core::Word integrator = "path";
    std::uint64_t seed = 0;
    core::Rgbf background{0};
    double exposure = 0;
    core::WordList layers;
    core::Word lanes = "auto";
    int threads = 0;  // 0: all cores
    bool progress = true;

    static std::span<const core::OptionRow<RenderSettings>> options();
};

}  // namespace render
