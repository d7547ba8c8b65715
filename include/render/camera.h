// The eye: a pinhole, and the rectangle of the view that the picture shows.
#pragma once

#include "core/ray.h"

namespace render {

class Camera {
public:
    // view: the direction looked in, not a point, of any length > 0; up: not parallel to it.
    // fieldOfView: vertical, in degrees, in (0, 180). width, height: of the whole picture, in pixels.
    Camera(const glm::dvec3& eye, const glm::dvec3& view, const glm::dvec3& up, double fieldOfView, int width,
           int height);

    // The ray through a place in the picture, in pixels from its upper left corner: pixel (i, j) covers the unit
    // square from (i, j) to (i + 1, j + 1). The direction has unit length.
    template<class Real>
    core::Ray<Real> ray(const core::Vec2<Real>& place) const {
        const auto lanes = [](const core::Vec3f& v) { return core::broadcast<Real>(v); };
        const core::Vec3<Real> through = lanes(corner_) + lanes(right_) * place.x + lanes(down_) * place.y;
        return {lanes(eye_), glm::normalize(through)};
    }

private:
    core::Vec3f eye_;
    core::Vec3f corner_;  // from the eye to the picture's upper left corner, at distance 1 along the view
    core::Vec3f right_, down_;  // one pixel on
};

}  // namespace render
