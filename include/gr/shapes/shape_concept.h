// What a shape must have to be in the list of gr/shape.h, and what a node that makes one.
#pragma once

#include "core/bounds.h"
#include "core/transform.h"
#include "gr/shapes/flat_side.h"
#include "gr/shapes/shape_node.h"
#include "gr/shapes/surface.h"

#include <concepts>

namespace gr {

// In its own space. Where it is said for a float it must be so for lanes of them.
template<class Shape>
concept CompleteShape = requires(const Shape& shape, core::Rayf ray, float t, core::Vec3f margin, bool front,
                                 ShapePoint<float> point, core::Transform map) {
    typename Shape::template With<core::Lanes>;  // another shape in each lane; parts() tells what differs
    Shape::parts(shape);  // the numbers in which one differs from another, floats, as std::tie makes it
    { Shape::isSolid } -> std::convertible_to<bool>;  // whether it holds what is inside of it
    { Shape::isEndless } -> std::convertible_to<bool>;  // whether no box can hold it
    // Whether each face lies across an axis, surfaceAt puts points on it exactly, and intersect tells by one sign,
    // which rounding cannot turn, on which side of it a ray starts: see errorAt in gr/rounding.h.
    { Shape::isAxisFaced } -> std::convertible_to<bool>;
    // The smallest t with 0 < t < ray.tMax at which the ray meets it, or infinity. Where a ray starts is decided by
    // signs that rounding cannot turn, so that one which starts a hair outside stays outside.
    { shape.intersect(ray) } -> std::same_as<float>;
    // The point is kept `margin` away from the edges of its face, along each axis: far enough for a ray that goes
    // on from there, a hair off the face, to start on the same side of the faces beyond the edges.
    // front: of a solid, whether the ray comes from outside; where it starts may not tell, if it has gone through.
    { shape.surfaceAt(ray, t, margin, front) } -> std::same_as<ShapePoint<float>>;
    { shape.coordinatesAt(point) } -> std::same_as<Coordinates<float>>;
    { shape.bounds() } -> std::same_as<core::Bounds>;
    { shape.flatSides() } -> std::same_as<std::vector<FlatSide>>;
    // How far it reaches from the middle of its bounds along the world's axes, where `map` puts it.
    { shape.reachUnder(map) } -> std::same_as<core::Vec3f>;
};

// A solid has a level that is less than 0 inside, 0 on the surface and more than 0 outside; and it tells which parts of
// the ray's line it holds, as far as these are not behind the ray, the nearer first, so that intersect gives the first
// end that is ahead. Of a part that begins behind the ray, `enter` is any number that is not more than 0.
template<class Shape>
concept CompleteIfSolid =
    !Shape::isSolid || requires(const Shape& shape, glm::dvec3 p, core::Ray<double> exact, core::Rayf ray) {
    { shape.level(p) } -> std::same_as<double>;
    { shape.spans(ray)[0] } -> std::convertible_to<Interval<float>>;
    { shape.spans(exact)[0] } -> std::convertible_to<Interval<double>>;
};

template<class Node>
concept CompleteShapeNode = requires(const Node& node, glm::dmat4 around) {
    { Node::kind } -> std::convertible_to<core::Word>;  // its command is gr_ and this
    { Node::plural } -> std::convertible_to<core::Word>;  // in gr_stats
    node.shape();  // which it makes
    { node.placeIn(around) } -> std::same_as<glm::dmat4>;  // from the shape's own space
    { node.text() } -> std::same_as<std::string>;  // behind its kind in gr_print
};

}  // namespace gr
