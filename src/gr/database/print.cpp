#include "core/error.h"
#include "core/option.h"
#include "gr/database/database.h"

#include <algorithm>
#include <numeric>

namespace gr {
namespace {

// What a mesh has beside its triangles.
std::string knownOf(const Polyhedron& mesh) {
    std::vector<std::string> parts;
    if (mesh.hasNormals()) parts.push_back("normals");
    if (!mesh.uvs().empty()) parts.push_back("uv");
    if (!mesh.colours().empty()) parts.push_back("colours");
    if (!mesh.groups().empty())
        parts.push_back(std::to_string(mesh.groups().size()) + (mesh.groups().size() == 1 ? " group" : " groups"));
    const std::vector<std::string_view> words(parts.begin(), parts.end());
    return parts.empty() ? "" : " with " + core::listed(words, "and");
}

// Behind the node's name.
struct ContentText {
    std::string operator()(const TransformNode&) const { return "transform"; }
    template<CompleteShapeNode Shape>
    std::string operator()(const Shape& shape) const {
        return std::string(Shape::kind) + " " + shape.text();
    }
    template<IsCsgNode Content>
    std::string operator()(const Content&) const {
        return std::string(Content::kind);
    }
    std::string operator()(const PolyhedronNode& node) const {
        const std::string what = node.file.empty() ? "polyhedron" : "mesh \"" + node.file + "\"";
        return what + " of " + std::to_string(node.polyhedron->triangleCount()) + " triangles" +
               knownOf(*node.polyhedron);
    }
    std::string operator()(const AreaLightNode& light) const {
        return "area light {" + core::optionText(light.radiance) + "} " + nodeText(light.centre, light.size);
    }
    std::string operator()(const InstanceNode& instance) const { return "instance of " + instance.target->path(); }
};

// The three rows that change; the fourth is always 0 0 0 1.
std::string matrixText(const glm::dmat4& m) {
    std::string text;
    for (int row = 0; row < 3; ++row) {
        text += row == 0 ? "{" : " {";
        for (int column = 0; column < 4; ++column) {
            if (column > 0) text += " ";
            text += core::numberText(m[column][row] + 0);  // -0 becomes 0
        }
        text += "}";
    }
    return text;
}

}  // namespace

std::string Database::print(std::string_view path) const {
    const Node& top = find(path);
    std::string text;
    int depth = 0;
    for (const Node* node = &top; node != nullptr;) {
        text.append(2 * static_cast<std::size_t>(depth), ' ');
        text += node == &top ? node->path() : node->name;
        text += " " + std::visit(ContentText{}, node->content);
        if (node->material != nullptr) text += ", material " + node->material->name;
        if (node->matrix) text += ", matrix " + matrixText(*node->matrix);
        const Node* next = nextInSubtree(node, &top);
        if (next != nullptr) text += "\n";
        if (next != nullptr && next->parent == node) {
            ++depth;
        } else if (next != nullptr) {
            for (; node->parent != next->parent; node = node->parent) --depth;
        }
        node = next;
    }
    if (&top == &root_) text += namedLightsText();
    return text;
}

std::string Database::namedLightsText() const {
    std::vector<std::string> lines;
    for (const auto& [name, light] : lights_)
        lines.push_back("\n" + name + " " + std::visit([](const auto& one) { return one.text(); }, light));
    // A hash table has no order that stays.
    std::sort(lines.begin(), lines.end());
    return std::accumulate(lines.begin(), lines.end(), std::string());
}

}  // namespace gr
