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

// Each method alone and mixed; the last two lose draws to methods that they cannot do.
template<>
inline std::vector<Diffuse> parameterSets<Diffuse>() {
    const core::Rgbf orange(0.8f, 0.3f, 0);
    return {{},
            {.reflectance = core::Rgbf(1), .sampling = core::Weights{1, 0, 0, 0}},
            {.reflectance = orange, .sampling = core::Weights{0, 1, 0, 0}},
            {.reflectance = orange, .sampling = core::Weights{0.5f, 0.5f, 0, 0}, .perturbation = 30},
            {.reflectance = orange, .sampling = core::Weights{0.5f, 0, 0.5f, 0}},
            {.reflectance = orange, .sampling = core::Weights{0.25f, 0.25f, 0.25f, 0.25f}, .perturbation = 90}};
}

// Where only half vectors are drawn, a base is under a wide highlight alone: a narrow one's would hardly find its
// light.
template<>
inline std::vector<Shirley> parameterSets<Shirley>() {
    const core::Rgbf gold(0.8f, 0.6f, 0.1f), red(0.7f, 0.1f, 0.05f), black(0), white(1), pale(0.1f, 0.2f, 0.3f);
    return {{},
            {.diffuse = red, .specular = pale, .exponents = {0, 0}},
            {.diffuse = white, .specular = gold, .exponents = {10, 10000}},
            {.diffuse = red, .specular = white, .exponents = {10000, 10000}},
            {.diffuse = red, .specular = black, .exponents = {2, 60}, .sampling = core::Weights{1, 0, 0, 0}},
            {.diffuse = red, .specular = gold, .exponents = {100, 400}, .sampling = core::Weights{0, 1, 0, 0}},
            {.diffuse = black, .specular = gold, .exponents = {10000, 10}, .sampling = core::Weights{0, 0, 0, 1}},
            {.diffuse = white, .specular = pale, .exponents = {5, 1}, .sampling = core::Weights{0, 0, 0, 1}},
            {.diffuse = red,
             .specular = gold,
             .exponents = {1000, 1000},
             .sampling = core::Weights{0.4f, 0.3f, 0.1f, 0.2f},
             .perturbation = 20}};
}

template<>
inline std::vector<Dielectric> parameterSets<Dielectric>() {
    const core::Rgbf bluish(0.2f, 0.5f, 1);
    return {{},
            {.specular = bluish, .index = 1.33, .absorption = core::Rgbf(2, 0.1f, 0)},
            {.sampling = core::Weights{0, 0.3f, 0.7f, 0}},
            {.specular = bluish, .sampling = core::Weights{0, 1, 0, 0}, .perturbation = 20},
            {.sampling = core::Weights{0.5f, 0, 0.25f, 0.25f}, .perturbation = 90}};
}

// Whether a material reflects as nature does: as much back as there, and no more than arrives. The highlight of glass
// does not.
template<class M>
constexpr bool isPhysical = true;
template<>
inline constexpr bool isPhysical<Dielectric> = false;

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
