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

// A solid by how far away it is at least, less than 0 inside: each step along the ray is that long, so that none leads
// through the surface (Hart 1996).
template<class Distance>
OracleHit meetSolid(const OracleRay& ray, Distance&& distance) {
    const double length = glm::length(ray.direction), beyond = glm::length(ray.origin) + 8;
    double way = 0;
    for (int step = 0; step < 5000 && way < beyond; ++step) {
        const glm::dvec3 p = ray.at(way / length);
        const double left = std::abs(distance(p));
        if (left > 1e-10) {
            way += left;
            continue;
        }
        constexpr double e = 1e-7;
        const auto slope = [&](const glm::dvec3& axis) { return distance(p + axis * e) - distance(p - axis * e); };
        return {way / length, {slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})}};
    }
    return {};
}

// By how much a place is beside a cone of that radius at its top, across its side, or beyond one of its caps.
inline OracleShape meetCone(double top) {
    return [top](const OracleRay& ray, double grown) {
        return meetSolid(ray, [&](const glm::dvec3& p) {
            const double side = std::hypot(p.x, p.z) - (1 + (top - 1) * p.y) - grown;
            return std::max({side / std::hypot(1, top - 1), -p.y - grown, p.y - 1 - grown});
        });
    };
}

inline OracleShape meetTorus(double tube) {
    return [tube](const OracleRay& ray, double grown) {
        return meetSolid(ray,
                         [&](const glm::dvec3& p) { return std::hypot(std::hypot(p.x, p.z) - 1, p.y) - tube - grown; });
    };
}

inline OracleShape meetDisc(double hole) {
    return [hole](const OracleRay& ray, double grown) {
        const double t = -ray.origin.y / ray.direction.y, radius = std::hypot(ray.at(t).x, ray.at(t).z);
        OracleHit hit;
        if (radius <= 1 + grown && (hole == 0 || radius >= hole - grown)) hit.nearer(t, {0, 1, 0});
        return hit;
    };
}

inline OracleHit meetPlane(const OracleRay& ray, double) {
    OracleHit hit;
    hit.nearer(-ray.origin.y / ray.direction.y, {0, 1, 0});
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
    const char* name;
    NodeContent content;
    OracleShape shape;
    glm::dvec2 over{0.1, 0.2};  // the x and z of a place that it is below
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

inline OracleObject oracleMesh(const char* name, const PolygonMesh& triangles) {
    return {name, polyhedronNode(triangles),
            [triangles](const OracleRay& ray, double grown) { return meetMesh(triangles, ray, grown); }};
}

inline std::vector<OracleObject> oracleObjects() {
    return {{"Sphere", SphereNode{}, meetSphere},
            {"Box", BoxNode{}, meetBox},
            {"Square", AreaLightNode{core::Rgbf(1), glm::dvec3(0), 1}, meetSquare},
            oracleMesh("Icosphere", icosphereMesh(1)),
            oracleMesh("ConcaveMesh", concaveMesh()),
            {"Cylinder", CylinderNode{}, meetCone(1)},
            {"Cone", ConeNode{}, meetCone(0)},
            {"ConeCut", ConeNode{.topRadius = 0.4}, meetCone(0.4)},
            {"Cup", ConeNode{.topRadius = 2}, meetCone(2)},
            {"Torus", TorusNode{}, meetTorus(0.25), {0.8, 0.6}},
            {"ThinTorus", TorusNode{.tube = 0.02}, meetTorus(0.02), {0.8, 0.6}},
            {"FatTorus", TorusNode{.tube = 0.9}, meetTorus(0.9), {0.8, 0.6}},
            {"Disc", DiscNode{}, meetDisc(0)},
            {"Ring", DiscNode{.hole = 0.6}, meetDisc(0.6), {0.8, 0}},
            {"Plane", PlaneNode{}, meetPlane}};
}

}  // namespace gr
