#include "core/parallel.h"

#include "core/fork_join.h"
#include "core/granted_threads.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace core {
namespace {

// Holds its order itself: a task finds that by the address that it is called with, before it reads anything.
struct Body {
    const std::function<void(int)>& task;
    ForkJoin order = {};

    void operator()(int i) const {
        const ForkJoin::Task here(order);
        task(i);
    }
};

void runTasks(int count, int threads, const std::function<void(int)>& task) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    const Body body{task};
    body.order.run([&] { arena.execute([&] { tbb::parallel_for(0, count, body, tbb::simple_partitioner{}); }); });
}

}  // namespace

int threadCount(int threads) {
    return grantedThreads(threads > 0 ? threads : tbb::this_task_arena::max_concurrency(), runTasks);
}

void parallelFor(int count, int threads, const std::function<void(int)>& task) {
    runTasks(count, grantedThreads(threads, runTasks), task);
}

}  // namespace core
