// CSG objects drawn at random, and an oracle that tells which places they hold: from the operands' formulas in double
// precision, operation by operation, without following any ray.
#pragma once

#include "gr/random_shapes.h"
#include "gr/scene.h"

#include <glm/matrix.hpp>

#include <functional>
#include <memory>

namespace gr {

// Less than 0 inside of a shape in its own space, more than 0 outside; about as large as the distance.
using OracleLevel = std::function<double(const glm::dvec3&)>;

inline double levelOfCone(const glm::dvec3& p, double top) {
    return std::max({std::hypot(p.x, p.z) - (1 + (top - 1) * p.y), -p.y, p.y - 1});
}

// Of a mesh about the origin that each ray from there meets once: by the planes of its faces, all of which look away.
inline double levelOfConvex(const PolygonMesh& mesh, const glm::dvec3& p) {
    double level = -1e9;
    for (const std::vector<int>& f : mesh.faces) {
        const glm::dvec3 a = mesh.vertices[f[0]], b = mesh.vertices[f[1]], c = mesh.vertices[f[2]];
        glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
        if (glm::dot(normal, a) < 0) normal = -normal;
        level = std::max(level, glm::dot(normal, p - a));
    }
    return level;
}

struct OracleOperand {
    const char* name;
    NodeContent content;
    OracleLevel level;
};

inline std::vector<OracleOperand> oracleOperands() {
    const auto torus = [](double tube) {
        return [tube](const glm::dvec3& p) { return std::hypot(std::hypot(p.x, p.z) - 1, p.y) - tube; };
    };
    const PolygonMesh cube = cubeMesh(), ball = icosphereMesh(1);
    return {{"sphere", SphereNode{}, [](const glm::dvec3& p) { return glm::length(p) - 1; }},
            {"box", BoxNode{glm::dvec3(-1), glm::dvec3(2)},
             [](const glm::dvec3& p) { return core::largestComponent(p) - 1; }},
            {"cylinder", CylinderNode{{0, -1, 0}, 1, 2},
             [](const glm::dvec3& p) {
                 return levelOfCone({p.x, (p.y + 1) / 2, p.z}, 1);
             }},
            {"cone", ConeNode{{0, 0, 0}, 1, 1, 0.4}, [](const glm::dvec3& p) { return levelOfCone(p, 0.4); }},
            {"torus", TorusNode{}, torus(0.25)},
            {"torus", TorusNode{glm::dvec3(0), 1, 0.6}, torus(0.6)},
            {"cube", polyhedronNode(cube), [cube](const glm::dvec3& p) { return levelOfConvex(cube, p); }},
            {"ball", polyhedronNode(ball), [ball](const glm::dvec3& p) { return levelOfConvex(ball, p); }},
            {"plane", PlaneNode{}, [](const glm::dvec3& p) { return p.y; }}};
}

// A node of the tree as the oracle sees it.
struct OracleCsg {
    std::optional<CsgOperation> operation;  // none: an operand
    OracleLevel level;
    glm::dmat4 objectFromWorld{1};
    std::vector<OracleCsg> children;

    // Less than 0 inside, in units of the operands' own spaces.
    double at(const glm::dvec3& world) const {
        if (!operation) return level(transformed(objectFromWorld, world));
        double all = operation == CsgOperation::isUnion ? 1e9 : -1e9;
        for (std::size_t i = 0; i < children.size(); ++i) {
            const double one = children[i].at(world);
            if (operation == CsgOperation::isUnion)
                all = std::min(all, one);
            else
                all = std::max(all, operation == CsgOperation::isDifference && i > 0 ? -one : one);
        }
        return all;
    }
};

// Puts a random tree below `parent`, whose matrix is `around`. depth: of operations, at most.
class RandomCsg {
public:
    RandomCsg(Database& database, support::TestRandom& random) : database_(database), random_(random) {}

    OracleCsg make(const std::string& parent, const glm::dmat4& around, int depth) {
        static const std::vector<OracleOperand> operands = oracleOperands();
        const std::string name = "n" + std::to_string(count_++);
        const double kind = random_.next();
        if (depth == 0 || (kind < 0.3 && count_ > 1)) {
            // Planes are cut off by what is bounded: see below.
            const auto pick = static_cast<std::size_t>(random_.next() * static_cast<double>(operands.size() - 1));
            return operand(parent, name, around, operands[pick]);
        }
        const auto operation = static_cast<CsgOperation>(static_cast<int>(random_.next() * 3));
        const NodeContent contents[] = {UnionNode{}, IntersectionNode{}, DifferenceNode{}};
        const std::string path = database_.create(parent, name, contents[static_cast<std::size_t>(operation)]).path();
        const glm::dmat4 matrix = around * place(path, 0.4);
        OracleCsg made{operation, {}, glm::dmat4(1), {}};
        const int children = 2 + static_cast<int>(random_.next() * 2.5);
        for (int i = 0; i < children; ++i) made.children.push_back(make(path, matrix, depth - 1));
        if (operation != CsgOperation::isUnion && random_.next() < 0.4)
            made.children.push_back(operand(path, "plane", matrix, operands.back()));
        return made;
    }

private:
    OracleCsg operand(const std::string& parent, const std::string& name, const glm::dmat4& around,
                      const OracleOperand& one) {
        const std::string path = database_.create(parent, name, one.content).path();
        const glm::dmat4 matrix = around * place(path, 0.7);
        return {std::nullopt, one.level, glm::inverse(matrix), {}};
    }

    // Moves, turns and stretches a node, and mirrors every third.
    glm::dmat4 place(const std::string& path, double away) {
        database_.translate(path, randomPoint(random_, -away, away));
        for (int axis = 0; axis < 3; ++axis) database_.rotate(path, axis, 360 * random_.next());
        const double mirrored = random_.next() < 0.33 ? -1 : 1;
        database_.scale(path, glm::dvec3(0), randomPoint(random_, 0.5, 1.2) * glm::dvec3(1, 1, mirrored));
        return *database_.find(path).matrix;
    }

    Database& database_;
    support::TestRandom& random_;
    int count_ = 0;
};

}  // namespace gr
