#include "render/transport/camera.h"

#include <glm/trigonometric.hpp>

namespace render {

Camera::Camera(const glm::dvec3& eye, const glm::dvec3& view, const glm::dvec3& up, double fieldOfView, int width,
               int height)
    : eye_(eye) {
    const glm::dvec3 forward = glm::normalize(view);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::normalize(up)));
    const glm::dvec3 upward = glm::cross(right, forward);
    forward_ = forward;
    const double halfHeight = std::tan(glm::radians(fieldOfView) / 2);
    const double pixel = 2 * halfHeight / height;
    right_ = right * pixel;
    down_ = -upward * pixel;
    corner_ = forward + upward * halfHeight - right * (pixel * width / 2);
}

void Camera::setLens(double radius, double focalDistance) {
    lensX_ = core::Vec3f(glm::normalize(glm::dvec3(right_)) * radius);
    lensY_ = core::Vec3f(glm::normalize(glm::dvec3(down_)) * radius);
    focalDistance_ = static_cast<float>(focalDistance);
}

}  // namespace render
