// What the tests of the materials walk: every type of the list, and the parameters that it is tested with. A material
// that is new in the list is tested at its defaults; give it a specialisation of parameterSets here to test it at more.
#pragma once

#include "materials/material.h"

#include <gtest/gtest.h>

#include <vector>

namespace materials {

template<class M>
std::vector<M> parameterSets() {
    return {M{}};
}

template<>
inline std::vector<Diffuse> parameterSets<Diffuse>() {
    return {{}, {core::Rgbf(1)}, {core::Rgbf(0.8f, 0.3f, 0)}};
}

// The list as googletest wants it: TYPED_TEST_SUITE(Name, EveryMaterial, MaterialName).
template<class List>
struct TypesOf;
template<class... M>
struct TypesOf<std::variant<M...>> {
    using Type = testing::Types<M...>;
};
using EveryMaterial = TypesOf<Material>::Type;

struct MaterialName {
    template<class M>
    static std::string GetName(int) {
        return std::string(M::typeName);
    }
};

}  // namespace materials
