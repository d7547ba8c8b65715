// Lambert's formula (Photometria, 1760): the irradiance from a polygon that emits evenly, exact.
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <vector>

namespace render {

using Polygon = std::vector<glm::dvec3>;

// What of the polygon is above the plane through the point (Sutherland and Hodgman).
inline Polygon aboveHorizon(const Polygon& polygon, const glm::dvec3& point, const glm::dvec3& normal) {
    Polygon above;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double heightA = glm::dot(a - point, normal);
        const double heightB = glm::dot(b - point, normal);
        if (heightA >= 0) above.push_back(a);
        if ((heightA >= 0) != (heightB >= 0)) above.push_back(a + (b - a) * (heightA / (heightA - heightB)));
    }
    return above;
}

// Per unit of radiance: half the sum, over the edges, of the angle that an edge fills as seen from the point, times the
// cosine between the surface's normal and that of the plane through edge and point. Either winding will do.
inline double lambertIrradiance(const Polygon& light, const glm::dvec3& point, const glm::dvec3& normal) {
    const Polygon polygon = aboveHorizon(light, point, normal);
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a = glm::normalize(polygon[i] - point);
        const glm::dvec3 b = glm::normalize(polygon[(i + 1) % polygon.size()] - point);
        const glm::dvec3 across = glm::cross(a, b);
        const double sine = glm::length(across);
        if (sine > 0) sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(across / sine, normal);
    }
    return std::abs(sum) / 2;
}

}  // namespace render
