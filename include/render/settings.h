// The render options: one row each. To add one: a member with its default, and a row.
#pragma once

#include "core/option.h"

namespace render {

struct RenderSettings {
    core::Word accelerator;  // none: see acceleratorName()
    bool globalIllumination = false;
    bool antialiasing = false;
    int pathLength = 2;
    bool depthOfField = false;
    std::optional<glm::dvec3> lookAt;  // a point in the middle of the picture, in place of a view
    std::optional<double> focalDistance;  // along the view; none: that of lookAt, or 1
    double aperture = 0.1;  // the lens' radius
    core::Word projection = "perspective";
    std::optional<int> startLine;  // 0 is the top; both lines are rendered
    std::optional<int> stopLine;
    std::optional<int> startColumn;  // 0 is on the left; both columns are rendered
    std::optional<int> stopColumn;
    std::optional<int> samplesPerPixel;  // see mostSamples()
    double noise = 0;  // the estimated relative error to go on to; 0: not asked for
    double time = 0;  // seconds to go on for; 0: not asked for
    int samplesPerLightSource = 1;
    core::Word integrator = "path";
    std::uint64_t seed = 0;
    core::Rgbf background{0};
    std::string environment;  // a texture's or a picture's name, as it was given; empty: none
    std::string environmentPath;  // and where it is, seen from the script that gave it
    double environmentRotation = 0;  // degrees
    double exposure = 0;
    core::Word curve = "srgb";
    core::WordList layers;
    core::Word lanes = "auto";
    int threads = 0;  // 0: all cores
    bool progress = true;
    bool resume = false;
    double checkpoint = 60;  // seconds
    bool keep = false;

    // The fastest; but of the report's integrator its own way, which is to test every object.
    core::Word acceleratorName() const {
        return !accelerator.empty() ? accelerator : integrator == "report" ? core::Word("off") : core::Word("auto");
    }
    // Whether how many samples a pixel gets is found out while rendering.
    bool isOpenEnded() const { return noise > 0 || time > 0; }
    // How many samples a pixel gets at the most; where it is not open-ended, just so many.
    int mostSamples() const { return samplesPerPixel.value_or(isOpenEnded() ? 1 << 20 : 16); }
    // How many an even spread over the pixel counts on; 1 where nobody knows.
    int samplesSpread() const { return isOpenEnded() ? 1 : mostSamples(); }

    static std::span<const core::OptionRow<RenderSettings>> options();
};

}  // namespace render
