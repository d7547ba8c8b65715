// What a grid is better off without.
#pragma once

#include "core/bounds.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gr {

// Of the items, given by their places in `bounds`.
core::Bounds boxOf(std::span<const core::Bounds> bounds, std::span<const std::uint32_t> items);

// Takes out the few that each alone make the box much larger, such as a lamp far above everything, and returns them.
std::vector<std::uint32_t> takeOutliers(std::span<const core::Bounds> bounds, std::vector<std::uint32_t>& items);

}  // namespace gr
