// A solid made of others: its operands are instances of the scene that no ray meets but by way of it.
#pragma once

#include "core/bounds.h"
#include "core/transform.h"
#include "gr/csg/csg_tree.h"
#include "gr/shapes/flat_side.h"
#include "gr/shapes/surface.h"

#include <memory>
#include <span>
#include <vector>

namespace gr {

class MeshTrees;
class ObjectTree;
class Scene;

class Csg {
public:
    static constexpr bool isEndless = false, isAxisFaced = false;

    // The operands are the scene's instances from `first` on, in the order in which the tree numbers them.
    Csg(CsgTree tree, std::uint32_t first);
    ~Csg();

    // To be called whenever an operand has been placed. Gives all of them an error bound that they share, so that a
    // step off the surface of one gets beyond those of others at the same place, too.
    void place(Scene& scene);
    // To be called once, when the operands stand where they stay. meshes: with trees that no device has built.
    void finish(const Scene& scene, MeshTrees& meshes);

    const CsgTree& tree() const { return tree_; }
    std::uint32_t firstOperand() const { return first_; }
    std::uint32_t operandCount() const { return static_cast<std::uint32_t>(tree_.operandCount()); }
    // Those that have an end, and those that have none.
    const ObjectTree& bounded() const { return *bounded_; }
    std::span<const std::uint32_t> endless() const { return endless_; }
    bool hasMeshes() const { return hasMeshes_; }
    // Surfaces of two operands that are nearer to each other than this are one.
    float tolerance() const { return tolerance_; }
    // How far apart, in t, two crossings of a ray may be at most where their surfaces are one. A ray along a surface
    // comes out of what rounding leaves of it only after a long way; up to the slope `flattest` it is counted as what
    // it is.
    static constexpr float flattest = 0x1p-10f;
    template<class Real>
    Real farthestFilm(const core::Vec3<Real>& direction) const {
        return Real(tolerance_) / (Real(flattest) * core::sqrt(glm::dot(direction, direction)));
    }

    // In the scene: it stands where its operands do. Empty where they hold nothing, infinite where none bounds it.
    core::Bounds bounds() const { return bounds_; }
    core::Vec3f reachUnder(const core::Transform& map) const { return reachOfBox(map, bounds_.size() * 0.5f); }
    // Those of its operands count.
    std::vector<FlatSide> flatSides() const { return {}; }
    std::size_t bytes() const;

private:
    core::Bounds boundsIn(const Scene& scene) const;

    CsgTree tree_;
    std::uint32_t first_;
    core::Bounds bounds_;
    std::unique_ptr<ObjectTree> bounded_;
    std::vector<std::uint32_t> endless_;
    bool hasMeshes_ = false;
    float tolerance_ = 0;
};

}  // namespace gr
