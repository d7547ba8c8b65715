// What light goes through inside of a material.
#pragma once

#include "core/elementary.h"
#include "core/vec.h"

#include <optional>

namespace materials {

struct Interior {
    float index = 1;  // of refraction, > 0
    core::Rgbf absorption{0};  // per unit length, >= 0

    // Beer's law: what is left of light after a way inside.
    core::Rgbf transmittance(float length) const {
        const auto left = [&](float a) { return a == 0 ? 1.f : core::exp(-a * length); };
        return {left(absorption.x), left(absorption.y), left(absorption.z)};
    }
};

}  // namespace materials
