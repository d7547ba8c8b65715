// What a tree's leaves hold: up to eight triangles of a mesh, up to eight objects of a kind, side by side, so that one
// ray is tested against all of them at once, or one instance of a mesh, or a CSG object.
#pragma once

#include "gr/accelerators/wide_tree.h"
#include "gr/mesh/pack.h"
#include "gr/scene.h"

#include <array>

namespace gr {

struct alignas(64) TriangleLeaf {
    TrianglePackOf<treeWidth> triangles;
    std::uint32_t triangle[treeWidth];  // the number of each in its mesh
};

struct alignas(64) ObjectPack {
    std::uint32_t kind;  // which list entry of Shape, and whether any is placed by a general map: see packKind
    std::uint32_t count;
    std::uint32_t instance[treeWidth];
};

inline std::uint32_t packKind(const Shape& shape, bool anyIsGeneral) {
    return 2 * static_cast<std::uint32_t>(shape.index()) + (anyIsGeneral ? 1 : 0);
}

// One mesh.
struct MeshPack : ObjectPack {
    const WideTree* tree;
    Placement place;
};

// One CSG object.
struct CsgPack : ObjectPack {
    const Csg* csg;
};

// Objects of one shape. Map: how they are placed. Places behind the last one repeat it.
template<class Shape, template<class> class Map>
struct ShapePack : ObjectPack {
    static constexpr bool isSolid = isSolidShape<Shape>;
    static constexpr int rows = sizeof(Map<float>) / sizeof(float);
    static constexpr std::size_t parts = std::tuple_size_v<decltype(Shape::parts(std::declval<Shape&>()))>;
    alignas(32) float objectFromWorld[rows][treeWidth];
    alignas(32) std::array<std::array<float, treeWidth>, parts> parameters;  // in which one shape differs from another

    void set(std::size_t place, const Map<float>& map, const Shape& shape) {
        for (int row = 0; row < rows; ++row) objectFromWorld[row][place] = reinterpret_cast<const float*>(&map)[row];
        std::size_t row = 0;
        std::apply([&](const auto&... part) { ((parameters[row++][place] = part), ...); }, Shape::parts(shape));
    }

    // The t of those from place `first` on, as many as there are lanes, or infinity.
    template<class Lanes>
    Lanes intersect(const core::Ray<Lanes>& ray, int first) const {
        return visit(ray, first, [](const auto& shape, const core::Ray<Lanes>& own) { return shape.intersect(own); });
    }
    // Which parts of the ray's line they hold, of solids.
    template<class Lanes>
    auto spans(const core::Ray<Lanes>& ray, int first) const {
        return visit(ray, first, [](const auto& shape, const core::Ray<Lanes>& own) { return shape.spans(own); });
    }

private:
    // Calls f(shapes, ray) with the shapes and what the ray is in their own space.
    template<class Lanes, class F>
    auto visit(const core::Ray<Lanes>& ray, int first, F&& f) const {
        Map<Lanes> map;
        for (int row = 0; row < rows; ++row)
            reinterpret_cast<Lanes*>(&map)[row] = Lanes::load_aligned(objectFromWorld[row] + first);
        typename Shape::template With<Lanes> shape;
        std::size_t row = 0;
        std::apply([&](auto&... part) { ((part = Lanes::load_aligned(&parameters[row++][first])), ...); },
                   shape.parts(shape));
        return f(shape, core::Ray<Lanes>{map.point(ray.origin), map.vector(ray.direction), ray.tMax});
    }
};

// Calls f(pack) with the pack as what it is, a MeshPack, a CsgPack or a ShapePack: one branch for each list entry of
// Shape.
template<class Pack, class F>
bool visitPack(Pack& pack, F&& f) {
    const auto as = [&]<class Type>(std::type_identity<Type>) -> auto& {
        return static_cast<std::conditional_t<std::is_const_v<Pack>, const Type, Type>&>(pack);
    };
    const auto visitShape = [&]<class S>(std::type_identity<S>) {
        if constexpr (std::is_same_v<S, const Polyhedron*>)
            return f(as(std::type_identity<MeshPack>()));
        else if constexpr (std::is_same_v<S, const Csg*>)
            return f(as(std::type_identity<CsgPack>()));
        else if (pack.kind % 2 == 1)
            return f(as(std::type_identity<ShapePack<S, core::AffineMap>>()));
        else
            return f(as(std::type_identity<ShapePack<S, AlignedMapOf>>()));
    };
    bool result = false;
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        ((pack.kind / 2 == i &&
          (result = visitShape(std::type_identity<std::variant_alternative_t<i, Shape>>()), true)) ||
         ...);
    }
    (std::make_index_sequence<std::variant_size_v<Shape>>());
    return result;
}

}  // namespace gr
