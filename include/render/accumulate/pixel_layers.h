// The layers of one pixel, found from its samples one after the other.
#pragma once

#include "image/film.h"
#include "render/transport/integrator.h"

namespace render {

class PixelLayers {
public:
    // A sample that is finite.
    void add(const core::Rgbf& radiance, const FirstSurface& first);
    // Into those layers that the film has.
    void store(image::Film& film, int x, int y) const;

    // All its numbers, in their order.
    template<class F>
    void forEachNumber(F&& f) {
        for (double* number : {&samples_, &met_, &depth_}) f(*number);
        for (glm::dvec3* vector : {&albedo_, &normal_, &mean_, &squaredDeviations_})
            for (int axis = 0; axis < 3; ++axis) f((*vector)[axis]);
    }
    static constexpr std::size_t numberCount = 15;

private:
    double samples_ = 0;
    double met_ = 0;  // samples that met a surface
    glm::dvec3 albedo_{0}, normal_{0};  // sums
    double depth_ = 0;
    // Welford's recurrence: no cancellation however bright the pixel is.
    glm::dvec3 mean_{0}, squaredDeviations_{0};
};

}  // namespace render
