#include "image/film.h"

namespace image {

Film::Film(int width, int height, const Window& held, std::span<const Layer> layers)
    : width_(width),
      height_(height),
      held_(held),
      pixels_(static_cast<std::size_t>(held.width) * static_cast<std::size_t>(held.height)),
      hasLayers_(!layers.empty()) {
    for (const Layer layer : layers)
        layers_[static_cast<std::size_t>(layer)].resize(pixels_.size() * channelsOf(layer).size());
}

double Film::bytesFor(int width, int lines, std::span<const Layer> layers) {
    std::size_t bytesPerPixel = sizeof(core::Rgbf);
    for (const Layer layer : layers) bytesPerPixel += channelsOf(layer).size() * sizeof(float);
    return static_cast<double>(bytesPerPixel) * width * lines;
}

std::size_t Film::bytes() const {
    std::size_t bytes = pixels_.size() * sizeof(core::Rgbf);
    for (const std::vector<float>& numbers : layers_) bytes += numbers.size() * sizeof(float);
    return bytes;
}

}  // namespace image
