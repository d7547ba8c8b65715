// Skies that tests make.
#pragma once

#include "gr/light.h"

namespace gr {

// Every pixel as f(u, v) says of its middle.
template<class F>
SkyGrid skyOf(int width, int height, F&& f) {
    std::vector<core::Rgbf> radiances;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) radiances.push_back(f((x + 0.5) / width, (y + 0.5) / height));
    return SkyGrid(width, height, std::move(radiances));
}

inline SkyLight lightOf(const SkyGrid& grid, double turns = 0) {
    return {&grid, grid.unit(), static_cast<float>(turns)};
}

// Smooth, brighter on one side, in another colour elsewhere; nothing of it is black.
inline SkyGrid smoothSky() {
    return skyOf(24, 12, [](double u, double v) {
        return core::Rgbf(1.2 + std::cos(2 * M_PI * (u - 0.3)), 1.1 - v, 0.2 + 2 * v);
    });
}
// Black but for a few pixels: one by itself, one in a corner, one at a pole, two that are 10^5 times as bright.
inline SkyGrid spottedSky() {
    std::vector<core::Rgbf> radiances(16 * 8, core::Rgbf(0));
    for (const int i : {3 * 16 + 9, 15, 7 * 16 + 4}) radiances[static_cast<std::size_t>(i)] = {1, 2, 3};
    for (const int i : {5 * 16 + 12, 5 * 16 + 13}) radiances[static_cast<std::size_t>(i)] = {3e5f, 2e5f, 1e5f};
    return SkyGrid(16, 8, std::move(radiances));
}

}  // namespace gr
