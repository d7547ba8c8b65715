#include "render/accumulate/pixel_layers.h"

namespace render {

void PixelLayers::add(const core::Rgbf& radiance, const FirstSurface& first) {
    ++samples_;
    const glm::dvec3 deviation = glm::dvec3(radiance) - mean_;
    mean_ += deviation / samples_;
    squaredDeviations_ += deviation * (glm::dvec3(radiance) - mean_);
    if (!first.isMet()) return;
    ++met_;
    albedo_ += glm::dvec3(first.albedo);
    normal_ += glm::dvec3(first.normal);
    depth_ += static_cast<double>(first.distance);
}

void PixelLayers::store(image::Film& film, int x, int y) const {
    const auto put = [&](image::Layer layer, const glm::dvec3& value) {
        const std::span<float> numbers = film.at(layer, x, y);
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(value[static_cast<int>(i)]);
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double count = std::max(samples_, 1.0);
    put(image::Layer::albedo, albedo_ / count);
    put(image::Layer::normal, normal_ / count);
    put(image::Layer::depth, glm::dvec3(met_ > 0 ? depth_ / met_ : infinity));
    // The variance of one sample, without bias, over the number of samples.
    put(image::Layer::variance, samples_ > 1 ? squaredDeviations_ / (samples_ - 1) / samples_ : glm::dvec3(infinity));
    put(image::Layer::samples, glm::dvec3(samples_));
}

}  // namespace render
