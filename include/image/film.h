// The picture while it is being made: linear radiance, and the layers that were asked for.
#pragma once

#include "core/vec.h"
#include "image/image.h"
#include "image/layer.h"

#include <vector>

namespace image {

// A part of a picture of width x height pixels.
class Film {
public:
    // held: what it has of the whole picture.
    Film(int width, int height, const Window& held, std::span<const Layer> layers = {});
    // The lines startLine to startLine + lines - 1.
    Film(int width, int height, int startLine, int lines, std::span<const Layer> layers = {})
        : Film(width, height, {0, startLine, width, lines}, layers) {}

    int width() const { return width_; }
    int height() const { return height_; }
    const Window& held() const { return held_; }
    bool isPart() const { return held_ != Window{0, 0, width_, height_}; }
    int startLine() const { return held_.top; }
    int lines() const { return held_.height; }

    // x, y: in the whole picture, y counted from its top. What is held lies line after line.
    core::Rgbf& at(int x, int y) { return pixels_[index(x, y)]; }
    const core::Rgbf& at(int x, int y) const { return pixels_[index(x, y)]; }

    bool hasLayers() const { return hasLayers_; }
    // A pixel's numbers in a layer, as many as it has channels; none where the film does not hold the layer.
    std::span<float> at(Layer layer, int x, int y) { return numbers<float>(layers_, layer, x, y); }
    std::span<const float> at(Layer layer, int x, int y) const { return numbers<const float>(layers_, layer, x, y); }

    // width, lines: of what is held.
    static double bytesFor(int width, int lines, std::span<const Layer> layers = {});
    std::size_t bytes() const;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - held_.top) * static_cast<std::size_t>(held_.width) +
               static_cast<std::size_t>(x - held_.left);
    }
    template<class Number, class Layers>
    std::span<Number> numbers(Layers& layers, Layer layer, int x, int y) const {
        auto& all = layers[static_cast<std::size_t>(layer)];
        if (all.empty()) return {};
        const std::size_t channels = channelsOf(layer).size();
        return {&all[index(x, y) * channels], channels};
    }

    int width_, height_;
    Window held_;
    std::vector<core::Rgbf> pixels_;
    bool hasLayers_;
    std::array<std::vector<float>, layerCount> layers_;  // empty where not asked for
};

}  // namespace image
