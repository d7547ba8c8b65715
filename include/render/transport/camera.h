// The eye, a pinhole or a thin lens, and the rectangle of the view that the picture shows.
#pragma once

#include "core/ray.h"
#include "core/warp.h"

namespace render {

class Camera {
public:
    // view: the direction looked in, not a point, of any length > 0; up: not parallel to it.
    // fieldOfView: vertical, in degrees, in (0, 180). width, height: of the whole picture, in pixels.
    Camera(const glm::dvec3& eye, const glm::dvec3& view, const glm::dvec3& up, double fieldOfView, int width,
           int height);

    // A lens of that radius in place of the pinhole, across the view. What lies at focalDistance > 0 along the view is
    // in focus: a plane, not a sphere.
    void setLens(double radius, double focalDistance);
    bool hasLens() const { return lensX_ != core::Vec3f(0); }

    // The ray through a place in the picture, in pixels from its upper left corner: pixel (i, j) covers the unit
    // square from (i, j) to (i + 1, j + 1). The direction has unit length.
    template<class Real>
    core::Ray<Real> ray(const core::Vec2<Real>& place) const {
        const auto lanes = [](const core::Vec3f& v) { return core::broadcast<Real>(v); };
        const core::Vec3<Real> through = lanes(corner_) + lanes(right_) * place.x + lanes(down_) * place.y;
        return {lanes(eye_), glm::normalize(through)};
    }

    // The same from a place on the lens, drawn by u, uniform in the unit square: all that go through one place in the
    // picture meet where the ray through the lens' centre meets the plane in focus.
    template<class Real>
    core::Ray<Real> ray(const core::Vec2<Real>& place, const core::Vec2<Real>& u) const {
        const auto lanes = [](const core::Vec3f& v) { return core::broadcast<Real>(v); };
        const core::Vec3<Real> inFocus =
            (lanes(corner_) + lanes(right_) * place.x + lanes(down_) * place.y) * Real(focalDistance_);
        const core::Vec2<Real> onDisc = core::squareToUniformDisc(u);
        const core::Vec3<Real> onLens = lanes(lensX_) * onDisc.x + lanes(lensY_) * onDisc.y;
        return {lanes(eye_) + onLens, glm::normalize(inFocus - onLens)};
    }

    // How far along the view a point of a ray lies, which is at that distance, in lengths of the direction.
    template<class Real>
    Real depth(const core::Ray<Real>& ray, const Real& distance) const {
        return distance * glm::dot(ray.direction, core::broadcast<Real>(forward_));
    }

private:
    core::Vec3f eye_;
    core::Vec3f forward_;  // along the view, of unit length
    core::Vec3f corner_;  // from the eye to the picture's upper left corner, at distance 1 along the view
    core::Vec3f right_, down_;  // one pixel on
    core::Vec3f lensX_{0}, lensY_{0};  // the lens' radii, to the right and down
    float focalDistance_ = 1;
};

}  // namespace render
