#pragma once

#include "core/bounds.h"
#include "gr/shapes/frustum.h"
#include "gr/shapes/shape_node.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace gr {

// Closed, about the y axis, from a foot of radius 1 at y = 0 to y = 1.
template<class Number>
struct ConeOf {
    template<class Other>
    using With = ConeOf<Other>;
    static constexpr bool isSolid = true, isEndless = false, isAxisFaced = false;

    // A batch with one number in braces would read a whole batch of them.
    Number top = Number(0.f);  // the radius there; 0: it is pointed

    template<class Self>
    static auto parts(Self& self) {
        return std::tie(self.top);
    }

    template<class Real>
    Real level(const core::Vec3<Real>& p) const {
        return frustum<Real>().level(p);
    }
    template<class Real>
    Real intersect(const core::Ray<Real>& ray) const {
        return spans(ray)[0].first(ray);
    }
    template<class Real>
    std::array<Interval<Real>, 1> spans(const core::Ray<Real>& ray) const {
        return frustum<Real>().spans(ray);
    }
    template<class Real>
    ShapePoint<Real> surfaceAt(const core::Ray<Real>& ray, const Real& t, const core::Vec3<Real>& margin,
                               const core::Mask<Real>& front) const {
        return frustum<Real>().surfaceAt(ray, t, margin, front);
    }
    template<class Real>
    Coordinates<Real> coordinatesAt(const ShapePoint<Real>& point) const {
        return frustum<Real>().coordinatesAt(point);
    }

    std::vector<FlatSide> flatSides() const { return {squareAcrossY(0, 1, false), squareAcrossY(1, top, true)}; }
    core::Bounds bounds() const { return {{-widest(), 0, -widest()}, {widest(), 1, widest()}}; }
    // Half its axis, and its wider end.
    core::Vec3f reachUnder(const core::Transform& map) const {
        return glm::abs(map.y) * 0.5f + glm::sqrt(map.x * map.x + map.z * map.z) * widest();
    }

private:
    float widest() const { return std::max(top, 1.f); }
    template<class Real>
    Frustum<Real> frustum() const {
        return {Real(top) - Real(1)};
    }
};
using Cone = ConeOf<float>;

struct ConeNode {
    static constexpr core::Word kind = "cone", plural = "cones";

    glm::dvec3 foot{0};  // its middle
    double radius = 1, height = 1, topRadius = 0;

    Cone shape() const { return {static_cast<float>(topRadius / radius)}; }
    glm::dmat4 placeIn(const glm::dmat4& around) const { return shapePlace(around, foot, {radius, height, radius}); }
    std::string text() const {
        return nodeText(foot, radius, height) + (topRadius > 0 ? " " + core::numberText(topRadius) : "");
    }
};

}  // namespace gr
