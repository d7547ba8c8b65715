// A gr_render command, read and checked.
#pragma once

#include "grsh/commands.h"
#include "image/layer.h"
#include "render/settings.h"

namespace grsh {

struct RenderJob {
    std::string node;
    std::string file;
    int width = 0, height = 0;
    glm::dvec3 eye{0}, view{0}, up{0};
    double fieldOfView = 0;  // vertical, degrees
    core::Rgbf ambient{0};
    std::vector<std::string> lights;
    render::RenderSettings settings;

    int startLine() const { return settings.startLine.value_or(0); }
    int stopLine() const { return settings.stopLine.value_or(height - 1); }
    int lines() const { return stopLine() - startLine() + 1; }
    std::vector<image::Layer> layers() const { return image::layersNamed(settings.layers); }
};

RenderJob readRenderJob(Call& call);

}  // namespace grsh
