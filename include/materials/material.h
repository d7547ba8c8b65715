// THE list of materials. To add one: write its header here beside diffuse.h, with all that CompleteMaterial asks for,
// and add its name to Material. gr_material, its help, its errors, both integrators, the fingerprint and every
// statistical test walk this list.
#pragma once

#include "materials/dielectric.h"
#include "materials/diffuse.h"
#include "materials/material_concept.h"
#include "materials/shirley.h"
#include "materials/textures/texture.h"

#include <cstddef>
#include <type_traits>
#include <variant>
#include <vector>

namespace materials {

using Material = std::variant<Diffuse, Dielectric, Shirley>;

// One type at a time, so that the compiler says which lacks what.
template<class M>
struct MaterialType {
    static_assert(CompleteMaterial<M>, "a material of the list lacks something: what, the compiler says here");
    static constexpr bool isComplete = true;
};

template<class List>
struct MaterialList;
template<class... Types>
struct MaterialList<std::variant<Types...>> {
    static_assert((MaterialType<Types>::isComplete && ...));

    template<class Real>
    using Bsdf = std::variant<BsdfOf<Types, Real>...>;
    template<class M>
    static constexpr std::size_t indexOf = std::variant<std::type_identity<Types>...>(std::type_identity<M>()).index();
};

// What a material is at a surface point, or at one in each lane.
template<class Real>
using Bsdf = MaterialList<Material>::Bsdf<Real>;

template<class Real, class Point>
Bsdf<Real> bsdfAt(const Material& material, const Point& point) {
    return std::visit(
        [&]<class M>(const M& m) {
            return Bsdf<Real>(std::in_place_index<MaterialList<Material>::indexOf<M>>, m.template at<Real>(point));
        },
        material);
}

// A texture of a material: where its values belong, and between which numbers they are kept.
struct TextureUse {
    const Texture* texture;  // the material owns it
    std::size_t slot;
    core::Range range;

    template<class Real>
    core::Rgb<Real> at(const TexturePlace<Real>& place) const {
        const Real least(static_cast<float>(range.least)), most(static_cast<float>(range.most));
        const core::Rgb<Real> found = texture->at<Real>(place);
        const auto kept = [&](const Real& x) { return core::min(core::max(x, least), most); };
        return {kept(found.x), kept(found.y), kept(found.z)};
    }
};

std::vector<TextureUse> textureUses(const Material& material);

// Calls f.operator()<M>() for each material type M of the list, in its order.
template<class F>
void forEachMaterialType(F&& f) {
    [&]<class... Types>(std::type_identity<std::variant<Types...>>) {
        (f.template operator()<Types>(), ...);
    }(std::type_identity<Material>{});
}

}  // namespace materials
