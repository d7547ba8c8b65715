// What a picture can hold of each pixel beside its radiance. To add one: its name here, and its row in
// src/image/layer.cpp.
#pragma once

#include "core/option.h"

namespace image {

// Means over a pixel's samples: those that were not finite are left out.
enum class Layer {
    albedo,  // of the first surface, 0 to 1; 0 where there is none
    normal,  // the first surface's shading normal in the world, facing the eye; 0 where there is none
    depth,  // along the view, over the samples that met a surface; infinite where none did
    variance,  // of the pixel's radiance, which is a mean; infinite for fewer than two samples
    samples,  // how many there are
};

inline constexpr std::size_t layerCount = 5;

// What they are called in scripts, in the enum's order.
std::span<const core::Word> layerNames();
// What each of its numbers is called in an OpenEXR file.
std::span<const core::Word> channelsOf(Layer layer);
// names: of layerNames().
std::vector<Layer> layersNamed(std::span<const core::Word> names);

}  // namespace image
