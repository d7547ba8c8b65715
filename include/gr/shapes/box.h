#pragma once

#include "core/bounds.h"
#include "core/transform.h"
#include "gr/shapes/flat_side.h"
#include "gr/shapes/shape_node.h"
#include "gr/shapes/surface.h"

#include <array>
#include <tuple>

namespace gr {

// The box [0, 1]^3.
struct Box {
    template<class>
    using With = Box;
    static constexpr bool isSolid = true, isEndless = false, isAxisFaced = true;

    static auto parts(const Box&) { return std::tie(); }

    template<class Real>
    Real level(const core::Vec3<Real>& p) const {
        Real level(-core::infinity);
        for (int axis = 0; axis < 3; ++axis)
            level = core::max(level, core::max(Real(-p[axis]), Real(p[axis] - Real(1))));
        return level;
    }

    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        return spans(ray)[0].first(ray);
    }

    // Slabs (Kay and Kajiya 1986). A ray inside a face's plane makes 0 / 0; min and max then keep the bound so far.
    template<class Real>
    std::array<Interval<Real>, 1> spans(const core::Ray<Real>& ray) const {
        using core::select;
        Real enter(-core::infinity);
        Real leave(core::infinity);
        for (int axis = 0; axis < 3; ++axis) {
            const Real inverse = Real(1) / ray.direction[axis];
            const Real t0 = -ray.origin[axis] * inverse;
            const Real t1 = (Real(1) - ray.origin[axis]) * inverse;
            const core::Mask<Real> upwards = inverse > Real(0);
            enter = core::max(select(upwards, t0, t1), enter);
            leave = core::min(select(upwards, t1, t0), leave);
        }
        // Three roundings (Ize, "Robust BVH Ray Traversal", 2013): a ray along an edge does not slip between two slabs.
        return {{{enter, leave, enter <= leave * Real(1 + 4 * 0x1p-23f)}}};
    }

    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>& margin,
                               const core::Mask<Real>& outside) const {
        const Real zero(0), one(1);
        // The face is the nearest of those that a ray from there can meet: never one that looks the other way, however
        // near the edge to it.
        const core::Vec3<Real> hit = ray.origin + ray.direction * t;
        core::Vec3<Real> plane, distance;
        for (int i = 0; i < 3; ++i) {
            plane[i] = core::select(core::differ(ray.direction[i] > zero, outside), one, zero);
            distance[i] = core::abs(hit[i] - plane[i]);
        }
        const core::Mask<Real> isY = distance.y < distance.x;
        const core::Mask<Real> isZ = distance.z < core::select(isY, distance.y, distance.x);
        const core::Mask<Real> isX = !(isY | isZ), isOnlyY = isY & !isZ;
        const core::Mask<Real> isFace[3] = {isX, isOnlyY, isZ};
        core::Vec3<Real> position, normal;
        for (int i = 0; i < 3; ++i) {
            const Real least = core::min(margin[i], Real(0.5f));
            const Real inside = core::min(core::max(hit[i], least), one - least);
            position[i] = core::select(isFace[i], plane[i], inside);
            normal[i] = core::select(isFace[i], Real(2) * plane[i] - one, zero);
        }
        return {position, normal, outside};
    }

    // From 0 to 1 on each face: where that grows downwards along an axis it starts at the far end.
    template<class Real>
    Coordinates<Real> coordinatesAt(const ShapePoint<Real>& point) const {
        const Coordinates<Real> flat =
            flatCoordinates<Real>(point.position - core::Vec3<Real>(Real(0.5f)), point.normal);
        return {flat.uv + core::Vec2<Real>(Real(0.5f)), flat.tangent};
    }

    std::vector<FlatSide> flatSides() const {
        std::vector<FlatSide> sides;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 across(0), edge1(0), edge2(0);
            across[axis] = edge1[(axis + 1) % 3] = edge2[(axis + 2) % 3] = 1;
            sides.push_back({glm::dvec3(0), edge2, edge1});
            sides.push_back({across, edge1, edge2});
        }
        return sides;
    }
    core::Bounds bounds() const { return {core::Vec3f(0), core::Vec3f(1)}; }
    core::Vec3f reachUnder(const core::Transform& map) const { return reachOfBox(map, core::Vec3f(0.5f)); }
};

struct BoxNode {
    static constexpr core::Word kind = "box", plural = "boxes";

    glm::dvec3 corner{0};
    glm::dvec3 size{1};

    Box shape() const { return {}; }
    glm::dmat4 placeIn(const glm::dmat4& around) const { return shapePlace(around, corner, size); }
    std::string text() const { return vectorText(corner) + " " + vectorText(size); }
};

}  // namespace gr
