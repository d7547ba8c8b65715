// Work on all cores.
#pragma once

#include <functional>

namespace core {

// The number of threads that `threads` asks for, 0 being all cores; fewer where the system grants no more.
int threadCount(int threads);

// Calls task(0) to task(count - 1), each once, on so many threads, in no order. Ends when all have ended; what the
// tasks wrote can then be read.
void parallelFor(int count, int threads, const std::function<void(int)>& task);

}  // namespace core
