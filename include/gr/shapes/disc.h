#pragma once

#include "core/bounds.h"
#include "core/transform.h"
#include "gr/shapes/flat_side.h"
#include "gr/shapes/shape_node.h"
#include "gr/shapes/surface.h"

#include <tuple>

namespace gr {

// The disc of radius 1 in the x-z plane, facing +y, with a round hole in its middle.
template<class Number>
struct DiscOf {
    template<class Other>
    using With = DiscOf<Other>;
    static constexpr bool isSolid = false, isEndless = false, isAxisFaced = true;

    Number hole = Number(0.f);  // its radius, less than 1

    template<class Self>
    static auto parts(Self& self) {
        return std::tie(self.hole);
    }

    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        const Real t = -ray.origin.y / ray.direction.y;
        const Real x = ray.origin.x + ray.direction.x * t;
        const Real z = ray.origin.z + ray.direction.z * t;
        const Real square = x * x + z * z, least(hole);
        const core::Mask<Real> inside = (square <= Real(1)) & (square >= least * least);
        return core::select(inside & (t > Real(0)) & (t < ray.tMax), t, Real(core::infinity));
    }

    // The margin is kept from both edges, as far as there is room.
    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>& margin,
                               const core::Mask<Real>&) const {
        const core::Vec3<Real> p = ray.origin + ray.direction * t;
        const Real least(hole), most = (Real(1) + least) * Real(0.5f);
        const Real edge = core::min(Real(core::sqrt(margin.x * margin.x + margin.z * margin.z)), most - least);
        const Real radius = core::sqrt(p.x * p.x + p.z * p.z);
        const Real outwards = core::select(least > Real(0), least + edge, Real(0));
        const Real clamped = core::min(core::max(radius, outwards), Real(1) - edge);
        const Real scale = core::select(radius > Real(0), clamped / radius, Real(1));
        return {{p.x * scale, Real(0), p.z * scale}, {Real(0), Real(1), Real(0)}, ray.direction.y < Real(0)};
    }

    // The square round it.
    template<class Real>
    Coordinates<Real> coordinatesAt(const ShapePoint<Real>& point) const {
        const Coordinates<Real> flat = flatCoordinates<Real>(point.position, point.normal);
        return {flat.uv * Real(0.5f) + core::Vec2<Real>(Real(0.5f)), flat.tangent};
    }

    std::vector<FlatSide> flatSides() const { return {squareAcrossY(0, 1, true), squareAcrossY(0, 1, false)}; }
    core::Bounds bounds() const { return {{-1, 0, -1}, {1, 0, 1}}; }
    core::Vec3f reachUnder(const core::Transform& map) const { return glm::sqrt(map.x * map.x + map.z * map.z); }
};
using Disc = DiscOf<float>;

struct DiscNode {
    static constexpr core::Word kind = "disc", plural = "discs";

    glm::dvec3 centre{0};
    double radius = 1;
    double hole = 0;  // its radius, less than the disc's

    Disc shape() const { return {static_cast<float>(hole / radius)}; }
    glm::dmat4 placeIn(const glm::dmat4& around) const { return shapePlace(around, centre, glm::dvec3(radius)); }
    std::string text() const { return nodeText(centre, radius) + (hole > 0 ? " " + core::numberText(hole) : ""); }
};

}  // namespace gr
