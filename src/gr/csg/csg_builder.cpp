#include "gr/csg/csg_builder.h"

#include "core/error.h"
#include "gr/accelerators/object_tree.h"
#include "gr/csg/closed.h"

#include <cmath>

namespace gr {
namespace {

bool mayBeSolid(const NodeContent& content) {
    if (std::holds_alternative<PolyhedronNode>(content)) return true;
    return std::visit(
        []<class Content>(const Content& node) {
            if constexpr (CompleteShapeNode<Content>)
                return decltype(node.shape())::isSolid;
            else
                return false;
        },
        content);
}

// All that may be, for messages.
template<class... Nodes>
std::string solidKinds(std::type_identity<ShapeNodeList<Nodes...>>) {
    std::vector<std::string_view> kinds;
    ((isSolidShape<ShapeNodeList<>::ShapeOf<Nodes>> ? kinds.push_back(Nodes::plural) : void()), ...);
    kinds.push_back("closed meshes");
    return core::listed(kinds, "and");
}

}  // namespace

std::optional<CsgOperation> operationOf(const NodeContent& content) {
    return std::visit(
        []<class Content>(const Content&) -> std::optional<CsgOperation> {
            if constexpr (IsCsgNode<Content>)
                return Content::operation;
            else
                return std::nullopt;
        },
        content);
}

void CsgBuilder::addOperand(const Node& node, std::uint32_t parent) {
    checkSolid(node);
    open_->tree.addOperand(parent);
    Instance& instance = scene_.instances.back();
    instance.isOperand = 1;
    instance.isInverted = open_->tree.isInverted(open_->tree.operandCount() - 1);
}

void CsgBuilder::checkSolid(const Node& node) {
    const std::string whole = "cannot be an operand of \"" + open_->top->path() + "\"";
    if (!mayBeSolid(node.content))
        throw core::Error("CSG", "SOLID", node.path(),
                          "\"" + node.path() + "\" is no solid and " + whole + ": solids are " +
                              solidKinds(std::type_identity<ShapeNodes>()));
    const auto* mesh = std::get_if<PolyhedronNode>(&node.content);
    if (mesh == nullptr || !closedMeshes_.insert(mesh->polyhedron.get()).second) return;
    if (const std::size_t open = openEdges(*mesh->polyhedron); open > 0)
        throw core::Error("CSG", "OPEN", node.path(),
                          "\"" + node.path() + "\" is not closed, so it is no solid and " + whole + ": " +
                              std::to_string(open) + (open == 1 ? " edge is" : " edges are") + " open");
}

std::unique_ptr<Csg> CsgBuilder::finish(const NameOf& nameOf) {
    Open open = std::move(*open_);
    open_.reset();
    ++count_;
    if (open.tree.operandCount() == 0) return nullptr;
    open.tree.finish();
    auto csg = std::make_unique<Csg>(std::move(open.tree), open.first);
    csg->place(scene_);
    if (csg->bounds().isEmpty()) return nullptr;
    if (!std::isfinite(csg->bounds().reach()))
        throw core::Error("CSG", "ENDLESS", open.top->path(),
                          "\"" + open.top->path() +
                              "\" has no end: what a plane bounds must be cut off by an operand that has one, as in "
                              "a gr_intersection with a box");
    materialInside_ = findMaterialInside(open, nameOf);
    return csg;
}

std::uint32_t CsgBuilder::findMaterialInside(const Open& open, const NameOf& nameOf) const {
    std::uint32_t inside = scene_.instances[open.first].material;
    for (std::size_t i = open.first; i < scene_.instances.size(); ++i) {
        const std::uint32_t material = scene_.instances[i].material;
        if (!scene_.interiors[material] || material == inside) continue;
        if (scene_.interiors[inside])
            throw core::Error("CSG", "INTERIORS", open.top->path(),
                              "\"" + open.top->path() + "\" has operands of two transparent materials, " +
                                  nameOf(inside) + " and " + nameOf(material) + ", but one solid can hold only one");
        inside = material;
    }
    return inside;
}

void finishCsgs(Scene& scene, std::vector<core::Bounds>& boxes) {
    if (scene.csgs.empty()) return;
    scene.operandMeshes = std::make_shared<MeshTrees>(nullptr);
    for (const auto& csg : scene.csgs) csg->finish(scene, *scene.operandMeshes);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (std::holds_alternative<const Csg*>(scene.instances[i].shape)) boxes[i] = scene.instances[i].bounds();
}

}  // namespace gr
