#pragma once

#include "core/bounds.h"
#include "core/transform.h"
#include "gr/direction.h"
#include "gr/shapes/flat_side.h"
#include "gr/shapes/shape_node.h"
#include "gr/shapes/surface.h"

#include <array>
#include <tuple>

namespace gr {

// The plane y = 0 without end, facing +y. As a solid it is all that lies below.
struct Plane {
    template<class>
    using With = Plane;
    static constexpr bool isSolid = true, isEndless = true, isAxisFaced = true;

    static auto parts(const Plane&) { return std::tie(); }

    template<class Real>
    Real level(const core::Vec3<Real>& p) const {
        return p.y;
    }

    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        const Real t = -ray.origin.y / ray.direction.y;
        return core::select((t > Real(0)) & (t < ray.tMax), t, Real(core::infinity));
    }

    // Below it: up to where a line comes out, or from where one goes in.
    template<class Real>
    std::array<Interval<Real>, 1> spans(const core::Ray<Real>& ray) const {
        const Real zero(0), endless(core::infinity), rise = ray.direction.y;
        const Real t = -ray.origin.y / rise;
        const core::Mask<Real> exists = (rise != zero) | (ray.origin.y < zero);
        return {{{core::select(rise < zero, t, -endless), core::select(rise > zero, t, endless), exists}}};
    }

    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>&,
                               const core::Mask<Real>&) const {
        const core::Vec3<Real> p = ray.origin + ray.direction * t;
        return {{p.x, Real(0), p.z}, {Real(0), Real(1), Real(0)}, ray.direction.y < Real(0)};
    }

    template<class Real>
    Coordinates<Real> coordinatesAt(const ShapePoint<Real>& point) const {
        return flatCoordinates<Real>(point.position, point.normal);
    }

    std::vector<FlatSide> flatSides() const { return {squareAcrossY(0, 1e12, true)}; }  // nearly without end
    core::Bounds bounds() const { return {{-core::infinity, 0, -core::infinity}, {core::infinity, 0, core::infinity}}; }
    // Without end along each of the world's axes that is not the normal.
    core::Vec3f reachUnder(const core::Transform& map) const {
        core::Vec3f reach(0);
        for (int axis = 0; axis < 3; ++axis)
            if (map.x[axis] != 0 || map.z[axis] != 0) reach[axis] = core::infinity;
        return reach;
    }
};

struct PlaneNode {
    static constexpr core::Word kind = "plane", plural = "planes";

    glm::dvec3 point{0};
    glm::dvec3 normal{0, 1, 0};  // of any length but 0

    Plane shape() const { return {}; }
    glm::dmat4 placeIn(const glm::dmat4& around) const {
        const glm::dvec3 y = directionOf(normal), x = glm::normalize(eastOf<double>(y));
        glm::dmat4 turn(1);
        turn[0] = {x, 0};
        turn[1] = {y, 0};
        turn[2] = {glm::cross(x, y), 0};
        return glm::translate(around, point) * turn;
    }
    std::string text() const { return vectorText(point) + " " + vectorText(normal); }
};

}  // namespace gr
