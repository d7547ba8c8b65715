// A gr_render command, read and checked.
#pragma once

#include "grsh/commands.h"
#include "image/curve.h"
#include "image/image.h"
#include "image/layer.h"
#include "render/settings.h"

namespace grsh {

inline constexpr core::Range pixelRange{.least = 1, .most = 1000000};  // of a width or height

struct RenderJob {
    std::string node;
    std::string file;
    int width = 0, height = 0;
    glm::dvec3 eye{0}, view{0}, up{0};  // with lookat, view goes from eye to its point
    double fieldOfView = 0;  // vertical, degrees
    core::Rgbf ambient{0};
    std::vector<std::string> lights;
    render::RenderSettings settings;

    // What is rendered of the picture.
    int startLine() const { return settings.startLine.value_or(0); }
    int stopLine() const { return settings.stopLine.value_or(height - 1); }
    int lines() const { return stopLine() - startLine() + 1; }
    int startColumn() const { return settings.startColumn.value_or(0); }
    int stopColumn() const { return settings.stopColumn.value_or(width - 1); }
    int columns() const { return stopColumn() - startColumn() + 1; }
    image::Window window() const { return {startColumn(), startLine(), columns(), lines()}; }

    double focalDistance() const { return settings.focalDistance.value_or(settings.lookAt ? glm::length(view) : 1); }
    image::ViewTransform viewTransform() const { return {settings.exposure, image::curveNamed(settings.curve)}; }
    std::vector<image::Layer> layers() const { return image::layersNamed(settings.layers); }
};

// The options from word `first` on, into settings. The files that they name lie beside the script that names them.
void readRenderOptions(Call& call, std::size_t first, render::RenderSettings& settings);

RenderJob readRenderJob(Call& call);

}  // namespace grsh
