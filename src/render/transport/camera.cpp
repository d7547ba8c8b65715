#include "render/transport/camera.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>

namespace render {
namespace {

// In the order of Projection.
constexpr std::array<core::Word, 3> names{"perspective", "orthographic", "panorama"};

}  // namespace

std::span<const core::Word> projectionNames() {
    return names;
}

Projection projectionNamed(core::Word name) {
    return static_cast<Projection>(std::find(names.begin(), names.end(), name) - names.begin());
}

Camera::Camera(const CameraView& view)
    : projection_(view.projection), eye_(view.eye), turnsPerPixel_(1. / view.width, 0.5 / view.height) {
    const glm::dvec3 forward = glm::normalize(view.view);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::normalize(view.up)));
    const glm::dvec3 upward = glm::cross(right, forward);
    forward_ = forward;
    if (projection_ == Projection::panorama) {
        right_ = right;
        down_ = -upward;
        return;
    }
    const bool isParallel = projection_ == Projection::orthographic;
    const double halfHeight = std::tan(glm::radians(view.fieldOfView) / 2) * (isParallel ? view.focalDistance : 1);
    const double pixel = 2 * halfHeight / view.height;
    right_ = right * pixel;
    down_ = -upward * pixel;
    const glm::dvec3 toMiddle = isParallel ? glm::dvec3(0) : forward;
    corner_ = toMiddle + upward * halfHeight - right * (pixel * view.width / 2);
    otherCorner_ = toMiddle + upward * halfHeight + right * (pixel * view.width / 2);
}

void Camera::setLens(double radius, double focalDistance) {
    lensX_ = core::Vec3f(glm::normalize(glm::dvec3(right_)) * radius);
    lensY_ = core::Vec3f(glm::normalize(glm::dvec3(down_)) * radius);
    lensRadius_ = static_cast<float>(radius);
    focalDistance_ = static_cast<float>(focalDistance);
}

RayStarts Camera::starts() const {
    core::Bounds box{eye_, eye_};
    if (projection_ == Projection::orthographic) {
        // The corners lie round the eye, each opposite another.
        for (const core::Vec3f& corner : {corner_, otherCorner_})
            for (const core::Vec3f& place : {eye_ + corner, eye_ - corner}) box.include(place);
    } else if (!hasLens()) {
        return eye_;
    }
    const float beyondRounding = 1e-6f * (lensRadius_ + box.reach());
    return {eye_, box.widened(lensRadius_ + beyondRounding)};
}

}  // namespace render
