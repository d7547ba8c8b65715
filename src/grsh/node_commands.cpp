#include "grsh/commands.h"
#include "grsh/place.h"

#include <array>

namespace grsh {
namespace {

constexpr double mostCoordinate = 1e18;  // its square is still a float
constexpr core::Range coordinate{.least = -mostCoordinate, .most = mostCoordinate};
constexpr core::Range length{.least = 0, .most = mostCoordinate, .leastIncluded = false};

glm::dvec3 position(Call& call, std::size_t i, std::string_view what) {
    return call.words.vector(i, what, coordinate);
}

Tcl_Obj* create(Call& call, gr::NodeContent content) {
    const gr::Node& node = call.session.database.create(call.words.text(0), call.words.text(1), std::move(content));
    return textObject(node.path());
}

// Parent and name are looked at first: they come first in the script.
void checkNew(Call& call) {
    call.session.database.checkNew(call.words.text(0), call.words.text(1));
}

Tcl_Obj* makeTransform(Call& call) {
    return create(call, gr::TransformNode{});
}

Tcl_Obj* makeSphere(Call& call) {
    if (call.words.size() == 3) throwWrongWords();
    checkNew(call);
    gr::SphereNode sphere;
    if (call.words.size() == 4) {
        sphere.centre = position(call, 2, "centre");
        sphere.radius = call.words.number(3, "radius", length);
    }
    return create(call, sphere);
}

Tcl_Obj* makeBox(Call& call) {
    if (call.words.size() == 3) throwWrongWords();
    checkNew(call);
    gr::BoxNode box;
    if (call.words.size() == 4) {
        box.corner = position(call, 2, "corner");
        const bool isNumber = call.words.listLength(3) == 1;
        box.size = isNumber ? glm::dvec3(call.words.number(3, "size", length)) : call.words.vector(3, "size", length);
    }
    return create(call, box);
}

std::vector<glm::dvec3> readVertices(Call& call) {
    std::vector<glm::dvec3> vertices;
    const auto elements = elementsOf(call.words.object(2), "vertices", "a list of {x y z}");
    for (Tcl_Obj* element : elements)
        vertices.push_back(vectorFrom(element, "vertex " + std::to_string(vertices.size()), coordinate));
    if (vertices.size() < 3) throwBadValue("vertices", "at least three {x y z}", call.words.object(2));
    return vertices;
}

std::vector<std::vector<int>> readFaces(Call& call, std::size_t vertexCount) {
    const core::Range index{.least = 0, .most = static_cast<double>(vertexCount) - 1};
    std::vector<std::vector<int>> faces;
    for (Tcl_Obj* element : elementsOf(call.words.object(3), "faces", "a list of {i j k ...}")) {
        const std::string what = "face " + std::to_string(faces.size());
        const auto corners = elementsOf(element, what, "a list of vertex numbers");
        if (corners.size() < 3) throwBadValue(what, "at least three vertex numbers", element);
        std::vector<int>& face = faces.emplace_back();
        for (Tcl_Obj* corner : corners) face.push_back(integerFrom(corner, "vertex number in " + what, index));
    }
    if (faces.empty()) throwBadValue("faces", "at least one {i j k ...}", call.words.object(3));
    return faces;
}

Tcl_Obj* makePolyhedron(Call& call) {
    checkNew(call);
    gr::PolygonMesh mesh;
    mesh.vertices = readVertices(call);
    mesh.faces = readFaces(call, mesh.vertices.size());
    gr::MeshRepairs repairs;
    const auto polyhedron = gr::Polyhedron::make(mesh, repairs);
    Tcl_Obj* path = create(call, gr::PolyhedronNode{polyhedron});
    if (const std::string text = repairs.text(); !text.empty())
        warn(call, "gr_polyhedron: " + std::string(textOf(path)) + ": " + text);
    return path;
}

Tcl_Obj* makeMesh(Call& call) {
    checkNew(call);
    const std::string file(call.words.text(2));
    gr::MeshRepairs repairs;
    const auto polyhedron = call.session.database.readMesh(besideScript(call.interp, file), file, repairs);
    Tcl_Obj* path = create(call, gr::PolyhedronNode{polyhedron, file});
    if (const std::string text = repairs.text(); !text.empty())
        warn(call, "gr_mesh: " + std::string(textOf(path)) + ": \"" + file + "\": " + text);
    return path;
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
    return nullptr;
}

Tcl_Obj* print(Call& call) {
    return textObject(call.session.database.print(call.words.size() == 1 ? call.words.text(0) : ":"));
}

constexpr std::array<Command, 13> rows{{
    {"gr_transform", "", "pname name", 2, 2, makeTransform, "makes an inner node, which holds others"},
    {"gr_sphere", "", "pname name ?{x y z} radius?", 2, 4, makeSphere,
     "makes a sphere; without the tail, the unit sphere at the origin"},
    {"gr_box", "gr_cube", "pname name ?{x y z} size?", 2, 4, makeBox,
     "makes a box from the corner {x y z} to corner + size, a number or {sx sy sz}; without the tail, [0,1]^3"},
    {"gr_polyhedron", "", "pname name {{x y z} ...} {{i j k ...} ...}", 4, 4, makePolyhedron,
     "makes a polygon mesh: vertices, then faces of vertex numbers from 0; any simple polygon, concave ones too"},
    {"gr_mesh", "", "pname name file", 3, 3, makeMesh,
     "makes a mesh from a file, .obj, .ply, .stl, .gltf or .glb; its path is relative to the script's folder"},
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
    {"gr_reset", "", "", 0, 0, reset, "deletes everything: nodes, materials and lights"},
    {"gr_print", "", "?node?", 0, 1, print,
     "returns the tree as text, all of it with the lights behind it, or a node's"},
}};

}  // namespace

std::span<const Command> nodeCommands() {
    return rows;
}

}  // namespace grsh
