#include "grsh/commands.h"
#include "grsh/node_words.h"

#include <array>

namespace grsh {
namespace {

Tcl_Obj* makeTransform(Call& call) {
    return create(call, gr::TransformNode{});
}

template<gr::IsCsgNode Content>
Tcl_Obj* makeCsg(Call& call) {
    return create(call, Content{});
}

Tcl_Obj* makeInstance(Call& call) {
    auto& database = call.session.database;
    return textObject(database.createInstance(call.words.text(0), call.words.text(1), call.words.text(2)).path());
}

Tcl_Obj* makeAreaLight(Call& call) {
    checkNew(call);
    gr::AreaLightNode light;
    light.radiance = call.words.colour(2, "radiance", {.least = 0, .most = mostCoordinate});
    light.centre = position(call, 3, "centre");
    light.size = call.words.number(4, "size", length);
    return create(call, light);
}

Tcl_Obj* translate(Call& call) {
    call.session.database.find(call.words.text(0));
    call.session.database.translate(call.words.text(0), position(call, 1, "distance"));
    return nullptr;
}

Tcl_Obj* rotate(Call& call) {
    call.session.database.find(call.words.text(0));
    const std::string_view axis = call.words.text(1);
    const std::size_t index = axis.size() == 1 ? std::string_view("xyzXYZ").find(axis) : std::string_view::npos;
    if (index == std::string_view::npos) throwBadValue("axis", "x, y or z", call.words.object(1));
    const double degrees = call.words.number(2, "degrees", core::anyNumber);
    call.session.database.rotate(call.words.text(0), static_cast<int>(index % 3), degrees);
    return nullptr;
}

Tcl_Obj* scale(Call& call) {
    call.session.database.find(call.words.text(0));
    const bool hasCentre = call.words.size() == 3;
    const glm::dvec3 about = hasCentre ? position(call, 1, "centre") : glm::dvec3(0);
    const std::size_t factors = hasCentre ? 2 : 1;
    const glm::dvec3 by = position(call, factors, "factors");
    if (by.x == 0 || by.y == 0 || by.z == 0)
        throwBadValue("factors", "three finite numbers other than 0", call.words.object(factors));
    call.session.database.scale(call.words.text(0), about, by);
    return nullptr;
}

Tcl_Obj* remove(Call& call) {
    call.session.database.remove(call.words.text(0));
    return nullptr;
}

Tcl_Obj* reset(Call& call) {
    call.session.database.reset();
    call.session.defaults = {};
    return nullptr;
}

Tcl_Obj* print(Call& call) {
    return textObject(call.session.database.print(call.words.size() == 1 ? call.words.text(0) : ":"));
}

constexpr std::array<Command, 12> rows{{
    {"gr_transform", "", "pname name", 2, 2, makeTransform, "makes an inner node, which holds others"},
    {"gr_union", "", "pname name", 2, 2, makeCsg<gr::UnionNode>,
     "makes an inner node whose children become one solid: what any of them holds"},
    {"gr_intersection", "", "pname name", 2, 2, makeCsg<gr::IntersectionNode>,
     "makes an inner node whose children become one solid: what all of them hold"},
    {"gr_difference", "", "pname name", 2, 2, makeCsg<gr::DifferenceNode>,
     "makes an inner node whose children become one solid: the first, less all the others"},
    {"gr_instance", "", "pname name target", 3, 3, makeInstance, "places the subtree at the path target once more"},
    {"gr_als_planar", "", "pname name {r g b} {x y z} size", 5, 5, makeAreaLight,
     "makes a square area light centred at {x y z} in the x-z plane, with radiance {r g b} from its -y side"},
    {"gr_translate", "", "node {x y z}", 2, 2, translate,
     "moves a node; of several transforms the one written last acts first"},
    {"gr_rotate", "", "node x|y|z degrees", 3, 3, rotate,
     "turns a node about an axis, counter-clockwise seen from its tip"},
    {"gr_scale", "", "node ?{ox oy oz}? {sx sy sz}", 2, 3, scale,
     "scales a node about a point, the origin if none is given"},
    {"gr_delete", "", "node", 1, 1, remove, "deletes a node and all below it"},
    {"gr_reset", "", "", 0, 0, reset, "deletes everything: nodes, materials, lights and what gr_default has set"},
    {"gr_print", "", "?node?", 0, 1, print,
     "returns the tree as text, all of it with the lights behind it, or a node's"},
}};

}  // namespace

std::span<const Command> nodeCommands() {
    return rows;
}

}  // namespace grsh
