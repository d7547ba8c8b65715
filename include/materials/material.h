// THE list of materials. To add one: write its header here beside diffuse.h (parameters with defaults, typeName,
// options(), eval, pdfW, sample, interior and what else Diffuse has) and add its name to Material. gr_material, its
// help, its errors and every statistical test walk this list.
#pragma once

#include "materials/dielectric.h"
#include "materials/diffuse.h"
#include "materials/shirley.h"

#include <variant>

namespace materials {

using Material = std::variant<Diffuse, Dielectric, Shirley>;

// Calls f.operator()<M>() for each material type M of the list, in its order.
template<class F>
void forEachMaterialType(F&& f) {
    [&]<class... Types>(std::type_identity<std::variant<Types...>>) {
        (f.template operator()<Types>(), ...);
    }(std::type_identity<Material>{});
}

}  // namespace materials
