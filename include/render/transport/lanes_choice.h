// How many paths the path integrator follows at once: as many as the processor's registers hold.
#pragma once

#include "core/option.h"

namespace render {

// What the option `lanes` may be.
std::span<const core::Word> laneNames();
// Throws core::Error for what this processor does not have. lanes: one of laneNames().
void checkLanes(core::Word lanes);

}  // namespace render
