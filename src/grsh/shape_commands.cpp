// The commands that make shapes. A shape of the list that has no row here does not compile.

#include "grsh/commands.h"
#include "grsh/node_words.h"

#include <algorithm>
#include <array>

namespace grsh {
namespace {

// Words that may be left out, but only all of them.
bool hasTail(const Call& call, std::size_t least) {
    if (call.words.size() == 2) return false;
    if (call.words.size() < least) throwWrongWords();
    return true;
}

// A length less than another one.
double lengthBelow(Call& call, std::size_t i, std::string_view what, double most, bool mayBe0) {
    const core::Range range{.least = 0, .most = most, .leastIncluded = mayBe0, .mostIncluded = false};
    const double value = call.words.number(i, what, range);
    // As near to it as floats tell apart it would be that.
    if (!(static_cast<float>(value / most) < 1))
        throwBadValue(what, "noticeably less than " + core::numberText(most), call.words.object(i));
    return value;
}

Tcl_Obj* makeSphere(Call& call) {
    const bool isGiven = hasTail(call, 4);
    checkNew(call);
    gr::SphereNode sphere;
    if (isGiven) {
        sphere.centre = position(call, 2, "centre");
        sphere.radius = call.words.number(3, "radius", length);
    }
    return create(call, sphere);
}

Tcl_Obj* makeBox(Call& call) {
    const bool isGiven = hasTail(call, 4);
    checkNew(call);
    gr::BoxNode box;
    if (isGiven) {
        box.corner = position(call, 2, "corner");
        const bool isNumber = call.words.listLength(3) == 1;
        box.size = isNumber ? glm::dvec3(call.words.number(3, "size", length)) : call.words.vector(3, "size", length);
    }
    return create(call, box);
}

Tcl_Obj* makeCylinder(Call& call) {
    const bool isGiven = hasTail(call, 5);
    checkNew(call);
    gr::CylinderNode cylinder;
    if (isGiven) {
        cylinder.foot = position(call, 2, "foot");
        cylinder.radius = call.words.number(3, "radius", length);
        cylinder.height = call.words.number(4, "height", length);
    }
    return create(call, cylinder);
}

Tcl_Obj* makeCone(Call& call) {
    const bool isGiven = hasTail(call, 5);
    checkNew(call);
    gr::ConeNode cone;
    if (isGiven) {
        cone.foot = position(call, 2, "foot");
        cone.radius = call.words.number(3, "radius", length);
        cone.height = call.words.number(4, "height", length);
        // The foot's radius is the unit of the other one.
        const core::Range range{.least = 0, .most = 1e4 * cone.radius};
        if (call.words.size() == 6) cone.topRadius = call.words.number(5, "topradius", range);
    }
    return create(call, cone);
}

Tcl_Obj* makeTorus(Call& call) {
    const bool isGiven = hasTail(call, 5);
    checkNew(call);
    gr::TorusNode torus;
    if (isGiven) {
        torus.centre = position(call, 2, "centre");
        torus.radius = call.words.number(3, "radius", length);
        torus.tube = lengthBelow(call, 4, "tube", torus.radius, false);
    }
    return create(call, torus);
}

Tcl_Obj* makeDisc(Call& call) {
    const bool isGiven = hasTail(call, 4);
    checkNew(call);
    gr::DiscNode disc;
    if (isGiven) {
        disc.centre = position(call, 2, "centre");
        disc.radius = call.words.number(3, "radius", length);
        if (call.words.size() == 5) disc.hole = lengthBelow(call, 4, "hole", disc.radius, true);
    }
    return create(call, disc);
}

Tcl_Obj* makePlane(Call& call) {
    const bool isGiven = hasTail(call, 4);
    checkNew(call);
    gr::PlaneNode plane;
    if (isGiven) {
        plane.point = position(call, 2, "point");
        plane.normal = position(call, 3, "normal");
        if (plane.normal == glm::dvec3(0))
            throwBadValue("normal", "three finite numbers that are not all 0", call.words.object(3));
    }
    return create(call, plane);
}

constexpr std::array<Command, 7> rows{{
    {"gr_sphere", "", "pname name ?{x y z} radius?", 2, 4, makeSphere,
     "makes a sphere; without the tail, the unit sphere at the origin"},
    {"gr_box", "gr_cube", "pname name ?{x y z} size?", 2, 4, makeBox,
     "makes a box from the corner {x y z} to corner + size, a number or {sx sy sz}; without the tail, [0,1]^3"},
    {"gr_cylinder", "", "pname name ?{x y z} radius height?", 2, 5, makeCylinder,
     "makes a closed cylinder, upright on {x y z}; without the tail, of radius 1 and height 1 at the origin"},
    {"gr_cone", "", "pname name ?{x y z} radius height ?topradius??", 2, 6, makeCone,
     "makes a closed cone, upright on {x y z}, pointed or as wide at its top as said; without the tail as a cylinder"},
    {"gr_torus", "", "pname name ?{x y z} radius tube?", 2, 5, makeTorus,
     "makes a ring round the y axis of a tube of radius tube, which is less; without the tail, 1 and 0.25"},
    {"gr_disc", "", "pname name ?{x y z} radius ?hole??", 2, 5, makeDisc,
     "makes a flat disc that faces +y, with a hole of radius hole if given; without the tail, of radius 1"},
    {"gr_plane", "", "pname name ?{x y z} {nx ny nz}?", 2, 4, makePlane,
     "makes a plane without end through {x y z} across the normal; without the tail, y = 0 facing +y"},
}};

template<class... Nodes>
constexpr bool haveAllRows(std::type_identity<gr::ShapeNodeList<Nodes...>>) {
    const auto hasRow = [](core::Word kind) {
        return std::any_of(rows.begin(), rows.end(), [&](const Command& row) { return row.name.substr(3) == kind; });
    };
    return (hasRow(Nodes::kind) && ...);
}
static_assert(haveAllRows(std::type_identity<gr::ShapeNodes>()), "a shape of the list has no command here");

}  // namespace

std::span<const Command> shapeCommands() {
    return rows;
}

}  // namespace grsh
