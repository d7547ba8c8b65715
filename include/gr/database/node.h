// A node of the scene graph as scripts build it. A million of them are made in a loop: mind the bytes.
#pragma once

#include "core/vec.h"
#include "gr/shape.h"
#include "materials/material.h"

#include <memory>
#include <string>
#include <variant>

namespace gr {

struct Node;

// A material and the name that scripts know it by.
struct NamedMaterial {
    std::string name;
    materials::Material material;
    std::string words;  // what the script says of it
    mutable std::size_t users = 0;  // nodes that point at it
};

// Each has its kind, and that in the plural for gr_stats.
struct TransformNode {
    static constexpr core::Word kind = "transform", plural = "transforms";
};
// Their children are operands.
struct UnionNode {
    static constexpr core::Word kind = "union", plural = "unions";
    static constexpr CsgOperation operation = CsgOperation::isUnion;
};
struct IntersectionNode {
    static constexpr core::Word kind = "intersection", plural = "intersections";
    static constexpr CsgOperation operation = CsgOperation::isIntersection;
};
struct DifferenceNode {
    static constexpr core::Word kind = "difference", plural = "differences";
    static constexpr CsgOperation operation = CsgOperation::isDifference;
};
template<class Content>
concept IsCsgNode = requires {
    Content::operation;
};

struct PolyhedronNode {
    static constexpr core::Word kind = "polyhedron", plural = "polyhedra";

    std::shared_ptr<const Polyhedron> polyhedron;
    std::string file{};  // as the script calls it; empty for one that the script gives itself
};
struct AreaLightNode {
    static constexpr core::Word kind = "area light", plural = "arealights";

    core::Rgbf radiance;
    glm::dvec3 centre;
    double size;
};
struct InstanceNode {
    static constexpr core::Word kind = "instance", plural = "instances";

    const Node* target;
};

// The shapes of the list have nodes of their own, which are in the list, too.
using NodeContent = ShapeNodes::Between<TransformNode, UnionNode, IntersectionNode, DifferenceNode, PolyhedronNode,
                                        AreaLightNode, InstanceNode>;

struct Node {
    std::string name;
    NodeContent content;
    std::unique_ptr<glm::dmat4> matrix;  // null: the identity
    const NamedMaterial* material = nullptr;  // null: the nearest ancestor's
    Node* parent = nullptr;
    // Children in the order they were made; a node is owned by the database.
    Node* firstChild = nullptr;
    Node* lastChild = nullptr;
    Node* previous = nullptr;
    Node* next = nullptr;

    std::string path() const;
};

// The node after `node` in the subtree of `top`, parents before their children, or null at the end. Neither time nor
// stack depends on how deep the tree is.
const Node* nextInSubtree(const Node* node, const Node* top);

}  // namespace gr
