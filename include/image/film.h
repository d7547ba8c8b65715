// The picture while it is being made: linear radiance, and the layers that were asked for.
#pragma once

#include "core/vec.h"
#include "image/layer.h"

#include <vector>

namespace image {

// The lines startLine to startLine + lines - 1 of a picture of width x height pixels.
class Film {
public:
    Film(int width, int height, int startLine, int lines, std::span<const Layer> layers = {});

    int width() const { return width_; }
    int height() const { return height_; }
    int startLine() const { return startLine_; }
    int lines() const { return lines_; }

    // x, y: in the whole picture, y counted from its top.
    core::Rgbf& at(int x, int y) { return pixels_[index(x, y)]; }
    const core::Rgbf& at(int x, int y) const { return pixels_[index(x, y)]; }

    bool hasLayers() const { return hasLayers_; }
    // A pixel's numbers in a layer, as many as it has channels; none where the film does not hold the layer.
    std::span<float> at(Layer layer, int x, int y) { return numbers<float>(layers_, layer, x, y); }
    std::span<const float> at(Layer layer, int x, int y) const { return numbers<const float>(layers_, layer, x, y); }

    static double bytesFor(int width, int lines, std::span<const Layer> layers = {});
    std::size_t bytes() const;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - startLine_) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    template<class Number, class Layers>
    std::span<Number> numbers(Layers& layers, Layer layer, int x, int y) const {
        auto& all = layers[static_cast<std::size_t>(layer)];
        if (all.empty()) return {};
        const std::size_t channels = channelsOf(layer).size();
        return {&all[index(x, y) * channels], channels};
    }

    int width_, height_, startLine_, lines_;
    std::vector<core::Rgbf> pixels_;
    bool hasLayers_;
    std::array<std::vector<float>, layerCount> layers_;  // empty where not asked for
};

}  // namespace image
