// THE list of materials. To add one: write its header here beside diffuse.h (parameters with defaults, typeName,
// options(), eval, pdfW, sample, ambientReflectance) and add its name to Material. gr_material, its help, its errors
// and every statistical test walk this list.
#pragma once

#include "materials/diffuse.h"

#include <variant>

namespace materials {

using Material = std::variant<Diffuse>;

// Calls f.operator()<M>() for each material type M of the list, in its order.
template<class F>
void forEachMaterialType(F&& f) {
    [&]<class... Types>(std::type_identity<std::variant<Types...>>) {
        (f.template operator()<Types>(), ...);
    }(std::type_identity<Material>{});
}

}  // namespace materials
