// What the system leaves of the threads that are asked for.
#pragma once

#include <functional>

namespace core {

// Has TBB run task(0) to task(count - 1) on so many threads.
using RunTasks = void (*)(int count, int threads, const std::function<void(int)>& task);

// How many of so many threads, this one among them, TBB may be asked for: it ends the process where it cannot start
// one. Has it start them, by run.
int grantedThreads(int threads, RunTasks run);

}  // namespace core
