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

constexpr std::string_view aboutOperands =
    "operands are spheres, boxes, cylinders, cones, tori, closed meshes, the three kinds again, and instances of "
    "these\n"
    "a gr_transform is the union of its children; a gr_plane is all below it, which another operand must cut off\n"
    "where an operand cuts, its own material is seen\n"
    "what is no solid is an error when it is rendered";

constexpr std::array<Command, 9> rows{{
    {"gr_transform", "", "pname name", 2, 2, makeTransform, "makes an inner node, which holds others"},
    {"gr_union", "", "pname name", 2, 2, makeCsg<gr::UnionNode>,
     "makes an inner node whose children become one solid: what any of them holds", aboutOperands},
    {"gr_intersection", "", "pname name", 2, 2, makeCsg<gr::IntersectionNode>,
     "makes an inner node whose children become one solid: what all of them hold", aboutOperands},
    {"gr_difference", "", "pname name", 2, 2, makeCsg<gr::DifferenceNode>,
     "makes an inner node whose children become one solid: the first, less all the others", aboutOperands},
    {"gr_instance", "", "pname name target", 3, 3, makeInstance, "places the subtree at the path target once more"},
    {"gr_als_planar", "", "pname name {r g b} {x y z} size", 5, 5, makeAreaLight,
     "makes a square area light centred at {x y z} in the x-z plane, with radiance {r g b} from its -y side"},
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
