// The commands that move, turn and scale nodes.

#include "gr/direction.h"
#include "grsh/commands.h"
#include "grsh/node_words.h"

#include <array>

namespace grsh {
namespace {

// The node is looked at first: it comes first in the script.
std::string_view nodeOf(Call& call) {
    call.session.database.find(call.words.text(0));
    return call.words.text(0);
}

Tcl_Obj* translate(Call& call) {
    const std::string_view node = nodeOf(call);
    call.session.database.translate(node, position(call, 1, "distance"));
    return nullptr;
}

Tcl_Obj* rotate(Call& call) {
    constexpr std::string_view expected = "x, y, z or three finite numbers that are not all 0";
    const std::string_view node = nodeOf(call), axis = call.words.text(1);
    const std::size_t index = axis.size() == 1 ? std::string_view("xyzXYZ").find(axis) : std::string_view::npos;
    const bool isNamed = index != std::string_view::npos;
    glm::dvec3 direction(0);
    if (!isNamed) {
        if (call.words.listLength(1) != 3) throwBadValue("axis", expected, call.words.object(1));
        direction = position(call, 1, "axis");
        if (direction == glm::dvec3(0)) throwBadValue("axis", expected, call.words.object(1));
    }
    const double degrees = call.words.number(2, "degrees", core::anyNumber);
    if (isNamed)
        call.session.database.rotate(node, static_cast<int>(index % 3), degrees);
    else
        call.session.database.rotate(node, direction, degrees);
    return nullptr;
}

Tcl_Obj* scale(Call& call) {
    const std::string_view node = nodeOf(call);
    const bool hasCentre = call.words.size() == 3;
    const glm::dvec3 about = hasCentre ? position(call, 1, "centre") : glm::dvec3(0);
    Tcl_Obj* factors = call.words.object(hasCentre ? 2 : 1);
    std::array<double, 3> by;
    oneOrMoreFrom(factors, "factors", coordinate, by);
    if (by[0] == 0 || by[1] == 0 || by[2] == 0)
        throwBadValue("factors", "one or three finite numbers other than 0", factors);
    call.session.database.scale(node, about, {by[0], by[1], by[2]});
    return nullptr;
}

// Whether what it makes of space is flat. Shears so strong that double precision cannot tell count, too.
bool isSingular(const glm::dmat3& m) {
    const double lengths = glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
    return !(std::abs(glm::determinant(m)) > 1e-12 * lengths);
}

Tcl_Obj* multiply(Call& call) {
    const std::string_view node = nodeOf(call);
    Tcl_Obj* word = call.words.object(1);
    std::array<double, 16> numbers;
    numbersFrom(word, "matrix", coordinate, numbers);
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = numbers[static_cast<std::size_t>(i)];
    const glm::dvec4 lastRow(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]), affine(0, 0, 0, 1);
    if (lastRow != affine) {
        const bool isTransposed = matrix[3] == affine;
        throw core::Error("VALUE", "AFFINE", std::string(textOf(word)),
                          "the last row of the matrix, its numbers 4, 8, 12 and 16, must be 0 0 0 1, not those of " +
                              quoted(textOf(word)) +
                              (isTransposed ? " (the first column comes first, and what moves is 13, 14 and 15)" : ""));
    }
    if (isSingular(glm::dmat3(matrix)))
        throw core::Error("VALUE", "SINGULAR", std::string(textOf(word)),
                          "the matrix must not be singular, as is " + quoted(textOf(word)) + ": nothing undoes it");
    call.session.database.multiply(node, matrix);
    return nullptr;
}

Tcl_Obj* lookAt(Call& call) {
    const std::string_view node = nodeOf(call);
    const glm::dvec3 eye = position(call, 1, "eye"), target = position(call, 2, "target"), up = position(call, 3, "up");
    if (eye == target) throwBadValue("target", "a point other than eye", call.words.object(2));
    if (up == glm::dvec3(0)) throwBadValue("up", "a direction, not of length 0", call.words.object(3));
    if (!(gr::sineBetween(target - eye, up) > 1e-9))
        throwBadValue("up", "a direction not parallel to that from eye to target", call.words.object(3));
    call.session.database.lookAt(node, eye, target, up);
    return nullptr;
}

Tcl_Obj* forget(Call& call) {
    call.session.database.forgetTransforms(call.words.text(0));
    return nullptr;
}

constexpr std::array<Command, 6> rows{{
    {"gr_translate", "", "node {x y z}", 2, 2, translate,
     "moves a node; of several transforms the one written last acts first"},
    {"gr_rotate", "", "node x|y|z|{ax ay az} degrees", 3, 3, rotate,
     "turns a node about an axis, counter-clockwise seen from its tip"},
    {"gr_scale", "", "node ?{ox oy oz}? {sx sy sz}", 2, 3, scale,
     "scales a node about a point, the origin if none is given; one number scales alike in all directions"},
    {"gr_matrix", "", "node {m1 ... m16}", 2, 2, multiply,
     "transforms a node by a matrix, column by column as in OpenGL; the last row is 0 0 0 1"},
    {"gr_lookat", "", "node {eye} {target} {up}", 4, 4, lookAt,
     "moves a node's origin to eye and turns it so that its -z axis points at target, and its y axis up"},
    {"gr_identity", "", "node", 1, 1, forget, "forgets the transforms of a node"},
}};

}  // namespace

std::span<const Command> transformCommands() {
    return rows;
}

}  // namespace grsh
