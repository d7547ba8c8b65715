// What the system leaves of the threads that are asked for.
#pragma once

namespace core {

// How many of so many threads, this one among them, TBB may be asked for: it ends the process where it cannot start
// one.
int grantedThreads(int threads);

}  // namespace core
