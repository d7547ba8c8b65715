// Where rays meet shapes, in double precision and each in another way than the renderer finds it.
#pragma once

#include "gr/random_shapes.h"

#include <functional>
#include <limits>
#include <optional>

namespace gr {

struct OracleRay {
    glm::dvec3 origin, direction;

    glm::dvec3 at(double t) const { return origin + direction * t; }
};

struct OracleHit {
    double t = std::numeric_limits<double>::infinity();
    glm::dvec3 normal{0};  // outward, not of unit length

    bool exists() const { return std::isfinite(t); }
    void nearer(double otherT, const glm::dvec3& otherNormal) {
        if (otherT > 0 && otherT < t) *this = {otherT, otherNormal};
    }
};

// A shape in its own space. grown: how much larger than it is, to tell which rays only just hit or miss.
using OracleShape = std::function<OracleHit(const OracleRay& ray, double grown)>;

inline OracleHit meetSphere(const OracleRay& ray, double grown) {
    const double a = glm::dot(ray.direction, ray.direction), b = glm::dot(ray.origin, ray.direction);
    const double c = glm::dot(ray.origin, ray.origin) - (1 + grown) * (1 + grown);
    const double root = std::sqrt(b * b - a * c);  // not a number where the ray misses
    OracleHit hit;
    for (const double t : {(-b - root) / a, (-b + root) / a}) hit.nearer(t, ray.at(t));
    return hit;
}

// A face at a time: where the ray meets its plane, and whether that is in the face.
inline OracleHit meetBox(const OracleRay& ray, double grown) {
    OracleHit hit;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1., 1.}) {
            const double plane = 0.5 + side * (0.5 + grown);
            const double t = (plane - ray.origin[axis]) / ray.direction[axis];
            bool inside = true;
            for (int other = 0; other < 3; ++other)
                inside = inside && (other == axis || std::abs(ray.at(t)[other] - 0.5) <= 0.5 + grown);
            glm::dvec3 normal(0);
            normal[axis] = side;
            if (inside) hit.nearer(t, normal);
        }
    }
    return hit;
}

inline OracleHit meetSquare(const OracleRay& ray, double grown) {
    const double t = -ray.origin.y / ray.direction.y;
    const glm::dvec3 p = glm::abs(ray.at(t));
    OracleHit hit;
    if (p.x <= 0.5 + grown && p.z <= 0.5 + grown) hit.nearer(t, {0, -1, 0});
    return hit;
}

// Möller and Trumbore: Cramer's rule for t and the weights of the second and the third vertex.
inline OracleHit meetMesh(const PolygonMesh& triangles, const OracleRay& ray, double grown) {
    OracleHit hit;
    for (const std::vector<int>& f : triangles.faces) {
        const glm::dvec3 a = triangles.vertices[f[0]];
        const glm::dvec3 e1 = triangles.vertices[f[1]] - a, e2 = triangles.vertices[f[2]] - a;
        const glm::dvec3 normal = glm::cross(e1, e2), q = glm::cross(ray.origin - a, ray.direction);
        const double determinant = -glm::dot(ray.direction, normal);
        const double b1 = glm::dot(e2, q) / determinant, b2 = -glm::dot(e1, q) / determinant;
        if (b1 >= -grown && b2 >= -grown && b1 + b2 <= 1 + grown)
            hit.nearer(glm::dot(ray.origin - a, normal) / determinant, normal);
    }
    return hit;
}

// A concave body of triangles around the origin.
inline PolygonMesh concaveMesh() {
    PolygonMesh mesh = icosphereMesh(0);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) mesh.vertices[i] *= 0.3;
    return mesh;
}

// A shape in the world, as a node and as the oracle sees it.
struct OracleObject {
    NodeContent content;
    OracleShape shape;
    glm::dmat4 worldFromObject{1};

    // The hit in the world; nothing where the ray passes so close to an edge that rounding may decide.
    std::optional<OracleHit> meet(const OracleRay& world) const {
        const glm::dmat4 inverse = glm::inverse(worldFromObject);
        const OracleRay ray{transformed(inverse, world.origin), glm::dmat3(inverse) * world.direction};
        constexpr double doubt = 1e-4;
        OracleHit hit = shape(ray, 0);
        const OracleHit smaller = shape(ray, -doubt), larger = shape(ray, doubt);
        if (smaller.exists() != larger.exists()) return std::nullopt;
        if (hit.exists() && std::abs(smaller.t - larger.t) > 0.01 * hit.t) return std::nullopt;
        hit.normal = glm::transpose(glm::dmat3(inverse)) * hit.normal;
        return hit;
    }
};

inline OracleObject oracleMesh(const PolygonMesh& triangles) {
    return {polyhedronNode(triangles),
            [triangles](const OracleRay& ray, double grown) { return meetMesh(triangles, ray, grown); }};
}

inline std::vector<OracleObject> oracleObjects() {
    return {{SphereNode{}, meetSphere},
            {BoxNode{}, meetBox},
            {AreaLightNode{core::Rgbf(1), glm::dvec3(0), 1}, meetSquare},
            oracleMesh(icosphereMesh(1)),
            oracleMesh(concaveMesh())};
}

}  // namespace gr
