// How many samples the next pass over a picture goes to.
#pragma once

#include <bit>

namespace render {

// 1, 2, 4, 8, and then by a quarter of the power of two that was reached: 10, 12, 14, 16, 20, ... Each pass adds enough
// to be worth while, and none goes far beyond what is needed.
inline int nextPass(int samples) {
    if (samples < 8) return samples == 0 ? 1 : 2 * static_cast<int>(std::bit_floor(static_cast<unsigned>(samples)));
    const int step = static_cast<int>(std::bit_floor(static_cast<unsigned>(samples))) / 4;
    return samples - samples % step + step;
}

}  // namespace render
