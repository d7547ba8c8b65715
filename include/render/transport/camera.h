// The eye, a pinhole or a thin lens, and what of the scene the picture shows.
#pragma once

#include "core/bounds.h"
#include "core/option.h"
#include "core/ray.h"
#include "core/warp.h"

namespace render {

enum class Projection {
    perspective,  // all rays through the eye
    orthographic,  // all rays along the view
    panorama  // all directions round the eye: longitude to the right, latitude upwards
};

std::span<const core::Word> projectionNames();
Projection projectionNamed(core::Word name);

// Where a camera's rays start: at the eye, or in a box round it.
struct RayStarts {
    core::Vec3f eye;
    core::Bounds box;

    RayStarts(const core::Vec3f& eye) : eye(eye), box{eye, eye} {}
    RayStarts(const core::Vec3f& eye, const core::Bounds& box) : eye(eye), box(box) {}
    bool isOnePoint() const { return box.low == box.high; }
};

// The rectangle that a picture shows of a plane across the view; of a panorama the view is the middle.
struct CameraView {
    // view: the direction looked in, not a point, of any length > 0; up: not parallel to it.
    // fieldOfView: vertical, in degrees, in (0, 180). width, height: of the whole picture, in pixels.
    glm::dvec3 eye, view, up;
    double fieldOfView;
    int width, height;
    Projection projection = Projection::perspective;
    // At this distance > 0 along the view an orthographic picture shows as much as one in perspective does.
    double focalDistance = 1;
};

class Camera {
public:
    explicit Camera(const CameraView& view);
    Camera(const glm::dvec3& eye, const glm::dvec3& view, const glm::dvec3& up, double fieldOfView, int width,
           int height)
        : Camera(CameraView{eye, view, up, fieldOfView, width, height}) {}

    // A lens of that radius in place of the pinhole, across the view; not of a panorama. What lies at focalDistance > 0
    // along the view is in focus: a plane, not a sphere.
    void setLens(double radius, double focalDistance);
    bool hasLens() const { return lensX_ != core::Vec3f(0); }
    RayStarts starts() const;

    // The ray through a place in the picture, in pixels from its upper left corner: pixel (i, j) covers the unit
    // square from (i, j) to (i + 1, j + 1). The direction has unit length.
    template<class Real>
    core::Ray<Real> ray(const core::Vec2<Real>& place) const {
        const core::Vec3<Real> eye = core::broadcast<Real>(eye_);
        if (projection_ == Projection::orthographic) return {eye + through(place), core::broadcast<Real>(forward_)};
        if (projection_ == Projection::panorama) return {eye, allRound(place)};
        return {eye, glm::normalize(through(place))};
    }

    // The same from a place on the lens, drawn by u, uniform in the unit square: all that go through one place in the
    // picture meet where the ray through the lens' centre meets the plane in focus. Each place of an orthographic
    // picture has a lens of its own.
    template<class Real>
    core::Ray<Real> ray(const core::Vec2<Real>& place, const core::Vec2<Real>& u) const {
        const auto lanes = [](const core::Vec3f& v) { return core::broadcast<Real>(v); };
        const core::Vec2<Real> onDisc = core::squareToUniformDisc(u);
        const core::Vec3<Real> onLens = lanes(lensX_) * onDisc.x + lanes(lensY_) * onDisc.y;
        if (projection_ == Projection::orthographic)
            return {lanes(eye_) + through(place) + onLens,
                    glm::normalize(lanes(forward_) * Real(focalDistance_) - onLens)};
        return {lanes(eye_) + onLens, glm::normalize(through(place) * Real(focalDistance_) - onLens)};
    }

    // How far along the view a point of a ray lies, which is at that distance, in lengths of the direction; all round,
    // how far away it is.
    template<class Real>
    Real depth(const core::Ray<Real>& ray, const Real& distance) const {
        if (projection_ == Projection::panorama) return distance;
        return distance * glm::dot(ray.direction, core::broadcast<Real>(forward_));
    }

private:
    // From the eye to the place in the picture: in perspective at distance 1 along the view, orthographic across it.
    template<class Real>
    core::Vec3<Real> through(const core::Vec2<Real>& place) const {
        const auto lanes = [](const core::Vec3f& v) { return core::broadcast<Real>(v); };
        return lanes(corner_) + lanes(right_) * place.x + lanes(down_) * place.y;
    }

    // The picture's left edge looks back, a quarter to the right of it is left, and so on; its upper edge looks up.
    template<class Real>
    core::Vec3<Real> allRound(const core::Vec2<Real>& place) const {
        const auto lanes = [](const core::Vec3f& v) { return core::broadcast<Real>(v); };
        const core::SinCos<Real> longitude = core::sinCosTurns(place.x * Real(turnsPerPixel_.x));
        const core::SinCos<Real> fromUp = core::sinCosTurns(place.y * Real(turnsPerPixel_.y));
        const core::Vec3<Real> level = lanes(forward_) * longitude.cos + lanes(right_) * longitude.sin;
        return glm::normalize(-(level * fromUp.sin) - lanes(down_) * fromUp.cos);
    }

    Projection projection_;
    core::Vec3f eye_;
    core::Vec3f forward_;  // along the view, of unit length
    core::Vec3f corner_;  // from the eye to the picture's upper left corner, see through()
    core::Vec3f right_, down_;  // one pixel on; of a panorama of unit length
    core::Vec3f otherCorner_;  // likewise to the upper right one
    core::Vec2f turnsPerPixel_;  // of a panorama
    core::Vec3f lensX_{0}, lensY_{0};  // the lens' radii, to the right and down
    float lensRadius_ = 0;
    float focalDistance_ = 1;
};

}  // namespace render
