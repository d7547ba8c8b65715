// The options that every material has.
#pragma once

#include "core/option.h"

namespace materials {

// defaultText: what is mixed when the option is not given.
template<class Material>
core::OptionRow<Material> samplingRow(std::string_view defaultText) {
    return {
        .name = "sampling",
        .member = &Material::sampling,
        .range = core::notNegative,
        .form = "{a b c d}",
        .defaultText = defaultText,
        .help = "weights of the diffuse, the reflective, the refractive and Shirley's way to go on from the surface"};
}

template<class Material>
core::OptionRow<Material> perturbationRow(const core::Range& range) {
    return {.name = "perturbation",
            .member = &Material::perturbation,
            .range = range,
            .unit = "degrees",
            .help = "half angle of the cone that the reflective way draws from, about the mirror's direction"};
}

}  // namespace materials
