#include "core/parallel.h"

#include "core/granted_threads.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace core {
namespace {

// Distributions' libtbb is not compiled for ThreadSanitizer, which therefore does not see that a loop's tasks begin
// after what stands before the loop, and end before what stands behind it. This tells it; in other builds it is
// nothing.
class ForkJoin {
public:
#ifdef __SANITIZE_THREAD__
    static void fork() {
        __tsan_release(&forked_);
    }
    static void taskBegins() {
        __tsan_acquire(&forked_);
    }
    static void taskEnds() {
        __tsan_release(&joined_);
    }
    static void join() {
        __tsan_acquire(&joined_);
    }

private:
    static inline char forked_ = 0, joined_ = 0;
#else
    static void fork() {}
    static void taskBegins() {}
    static void taskEnds() {}
    static void join() {}
#endif
};

void runTasks(int count, int threads, const std::function<void(int)>& task) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    // The body is written before the fork, for the tasks read it.
    const auto body = [&](int i) {
        ForkJoin::taskBegins();
        task(i);
        ForkJoin::taskEnds();
    };
    ForkJoin::fork();
    arena.execute([&] { tbb::parallel_for(0, count, body, tbb::simple_partitioner{}); });
    ForkJoin::join();
}

}  // namespace

int threadCount(int threads) {
    return grantedThreads(threads > 0 ? threads : tbb::this_task_arena::max_concurrency(), runTasks);
}

void parallelFor(int count, int threads, const std::function<void(int)>& task) {
    runTasks(count, grantedThreads(threads, runTasks), task);
}

}  // namespace core
