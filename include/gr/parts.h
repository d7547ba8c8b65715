// Work on many things at once: on all cores, a part each.
#pragma once

#include "core/parallel.h"

#include <algorithm>

namespace gr {

// Calls function(first, end) for parts that together make 0 to count; few are one part.
template<class Function>
void inParts(int count, Function&& function) {
    constexpr int part = 1 << 15;
    if (count <= part) return function(0, count);
    core::parallelFor((count - 1) / part + 1, core::threadCount(0),
                      [&](int i) { function(i * part, static_cast<int>(std::min<long>((i + 1l) * part, count))); });
}

}  // namespace gr
