#include "gr/database/database.h"
#include "gr/direction.h"

#include <glm/ext/matrix_transform.hpp>

#include <cmath>

namespace gr {
namespace {

// Quarter turns are exact.
struct Turn {
    double sine, cosine;

    explicit Turn(double degrees) {
        const double turns = std::remainder(degrees, 360);
        const bool quarter = std::remainder(turns, 90) == 0;
        const double radians = glm::radians(turns);
        sine = quarter ? std::round(std::sin(radians)) : std::sin(radians);
        cosine = quarter ? std::round(std::cos(radians)) : std::cos(radians);
    }
};

}  // namespace

void Database::multiply(std::string_view path, const glm::dmat4& matrix) {
    Node& node = get(path);
    const glm::dmat4 product = node.matrix ? *node.matrix * matrix : matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            if (!std::isfinite(static_cast<float>(product[column][row])))
                throw core::Error("VALUE", "RANGE", node.path(),
                                  "the matrix of \"" + node.path() + "\" grows beyond numbers");
    if (!node.matrix) node.matrix = std::make_unique<glm::dmat4>();
    *node.matrix = product;
}

void Database::translate(std::string_view node, const glm::dvec3& by) {
    multiply(node, glm::translate(glm::dmat4(1), by));
}

void Database::rotate(std::string_view node, int axis, double degrees) {
    const Turn turn(degrees);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::dmat4 matrix(1);
    matrix[u][u] = matrix[v][v] = turn.cosine;
    matrix[u][v] = turn.sine;
    matrix[v][u] = -turn.sine;
    multiply(node, matrix);
}

void Database::rotate(std::string_view node, const glm::dvec3& axis, double degrees) {
    for (int i = 0; i < 3; ++i)
        if (axis[(i + 1) % 3] == 0 && axis[(i + 2) % 3] == 0) return rotate(node, i, axis[i] < 0 ? -degrees : degrees);
    // Rodrigues: what lies along the axis stays, what is across it is turned.
    const Turn turn(degrees);
    const glm::dvec3 n = directionOf(axis);
    glm::dmat4 matrix(1);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 unit(0);
        unit[i] = 1;
        const glm::dvec3 along = n[i] * n;
        matrix[i] = glm::dvec4(along + turn.cosine * (unit - along) + turn.sine * glm::cross(n, unit), 0);
    }
    multiply(node, matrix);
}

void Database::scale(std::string_view node, const glm::dvec3& about, const glm::dvec3& by) {
    multiply(node, glm::translate(glm::scale(glm::translate(glm::dmat4(1), about), by), -about));
}

void Database::lookAt(std::string_view node, const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
    const glm::dvec3 back = directionOf(eye - target);
    const glm::dvec3 right = glm::normalize(glm::cross(directionOf(up), back));
    const glm::dvec3 upwards = glm::cross(back, right);
    multiply(node, {glm::dvec4(right, 0), glm::dvec4(upwards, 0), glm::dvec4(back, 0), glm::dvec4(eye, 1)});
}

void Database::forgetTransforms(std::string_view node) {
    get(node).matrix.reset();
}

}  // namespace gr
