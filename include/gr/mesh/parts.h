// Work on many things at once, a part for each thread; 0 threads are all cores.
#pragma once

#include "core/parallel.h"

#include <algorithm>
#include <vector>

namespace gr {

inline constexpr int partSize = 1 << 15;

// Calls function(first, end) for parts that together make 0 to count; few are one part.
template<class Function>
void inParts(int count, int threads, Function&& function) {
    if (count <= partSize) return function(0, count);
    core::parallelFor((count - 1) / partSize + 1, core::threadCount(threads), [&](int i) {
        function(i * partSize, static_cast<int>(std::min<long>((i + 1l) * partSize, count)));
    });
}
template<class Function>
void inParts(int count, Function&& function) {
    inParts(count, 0, function);
}

// What function(first, end) returns for each part, in their order: however many threads there are, it adds up to the
// same.
template<class Value, class Function>
std::vector<Value> ofParts(int count, int threads, Function&& function) {
    std::vector<Value> values(static_cast<std::size_t>(std::max(count - 1, 0) / partSize + 1));
    inParts(count, threads, [&](int first, int end) { values[first / partSize] = function(first, end); });
    return values;
}
template<class Value, class Function>
std::vector<Value> ofParts(int count, Function&& function) {
    return ofParts<Value>(count, 0, function);
}

}  // namespace gr
