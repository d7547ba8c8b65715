// THE list of shapes. To add one: write its header in gr/shapes/ beside cylinder.h, with all that CompleteShape and
// CompleteShapeNode ask for, and add its node to ShapeNodes. Every tracer, the scene graph, the compiler, gr_print,
// gr_stats and the fingerprint walk this list; its command is a row of src/grsh/shape_commands.cpp.
#pragma once

#include "gr/csg/csg.h"
#include "gr/mesh/polyhedron.h"
#include "gr/shapes/box.h"
#include "gr/shapes/cone.h"
#include "gr/shapes/cylinder.h"
#include "gr/shapes/disc.h"
#include "gr/shapes/plane.h"
#include "gr/shapes/shape_concept.h"
#include "gr/shapes/sphere.h"
#include "gr/shapes/square.h"
#include "gr/shapes/torus.h"

#include <variant>

namespace gr {

// The nodes that make a shape each, by a command of their own.
template<class... Nodes>
struct ShapeNodeList {
    static_assert((CompleteShapeNode<Nodes> && ...), "a shape's node lacks something: see gr/shapes/shape_concept.h");

    template<class Node>
    using ShapeOf = decltype(std::declval<Node>().shape());
    static_assert((CompleteShape<ShapeOf<Nodes>> && ...), "a shape lacks something: see gr/shapes/shape_concept.h");
    static_assert((CompleteIfSolid<ShapeOf<Nodes>> && ...), "a solid shape lacks its level, or its spans");

    // A polyhedron is shared by all its instances; the scene owns it, as it does CSG objects. Squares are the area
    // lights'.
    using Shape = std::variant<const Polyhedron*, const Csg*, Square, ShapeOf<Nodes>...>;
    // These nodes between others.
    template<class First, class... Others>
    using Between = std::variant<First, Nodes..., Others...>;
};

using ShapeNodes = ShapeNodeList<SphereNode, BoxNode, CylinderNode, ConeNode, TorusNode, DiscNode, PlaneNode>;
using Shape = ShapeNodes::Shape;
static_assert(CompleteShape<Square>);

// Calls f with the shape as what it is, not by its pointer.
template<class F>
auto visitShape(const Shape& shape, F&& f) {
    return std::visit(
        [&]<class S>(const S& s) {
            if constexpr (std::is_pointer_v<S>)
                return f(*s);
            else
                return f(s);
        },
        shape);
}

// Whether a shape of one kind is a solid that is one of its own: one that tells its level and its spans.
template<class S>
inline constexpr bool isSolidShape = [] {
    if constexpr (std::is_pointer_v<S>)
        return false;
    else
        return S::isSolid;
}();

// Whether it is made of so many parts that it is tested by itself, not beside others of its kind.
inline bool isOneByOne(const Shape& shape) {
    return std::visit([]<class S>(const S&) { return std::is_pointer_v<S>; }, shape);
}
// How many things must be tested to test it.
inline std::size_t partsOf(const Shape& shape) {
    if (const auto* mesh = std::get_if<const Polyhedron*>(&shape)) return (*mesh)->triangleCount();
    if (const auto* csg = std::get_if<const Csg*>(&shape)) return (*csg)->operandCount();
    return 1;
}
inline bool isEndless(const Shape& shape) {
    return visitShape(shape, []<class S>(const S&) { return S::isEndless; });
}
inline bool isAxisFaced(const Shape& shape) {
    return visitShape(shape, []<class S>(const S&) { return S::isAxisFaced; });
}
inline core::Bounds boundsOf(const Shape& shape) {  // in its own space
    return visitShape(shape, [](const auto& s) { return s.bounds(); });
}

}  // namespace gr
