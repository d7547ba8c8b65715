#include "core/granted_threads.h"

#include <malloc.h>
#include <pthread.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <mutex>
#include <semaphore>
#include <thread>
#include <vector>

namespace core {
namespace {

// As much as TBB gives to a thread of its own, and something for what it then allocates.
constexpr std::size_t kStackBytes = std::size_t{5} << 20;

void* waitForEnd(void* end) {
    static_cast<std::counting_semaphore<>*>(end)->acquire();
    return nullptr;
}

// malloc reserves 64 MB of addresses for each thread's own arena. Where they are limited there are not as many.
void limitArenas() {
#ifdef M_ARENA_MAX
    rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) mallopt(M_ARENA_MAX, 1);
#endif
}

// How many of so many threads the system grants beside this one, all at once.
int startableThreads(int threads) {
    std::counting_semaphore<> end(0);
    std::vector<pthread_t> started;
    started.reserve(static_cast<std::size_t>(threads));
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, kStackBytes);
    for (pthread_t thread; static_cast<int>(started.size()) < threads; started.push_back(thread))
        if (pthread_create(&thread, &attributes, waitForEnd, &end) != 0) break;
    pthread_attr_destroy(&attributes);
    end.release(static_cast<std::ptrdiff_t>(started.size()));
    for (const pthread_t thread : started) pthread_join(thread, nullptr);
    return static_cast<int>(started.size());
}

// Has TBB start its threads now: later there may be no room for them.
void startThreads(int threads, RunTasks run) {
    std::atomic<int> arrived = 0;
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    run(threads, threads, [&](int) {
        ++arrived;
        while (arrived < threads && std::chrono::steady_clock::now() < until) std::this_thread::yield();
    });
}

}  // namespace

// Where the system granted fewer than were asked for it is not asked for as many again.
int grantedThreads(int threads, RunTasks run) {
    static std::mutex mutex;
    static int known = 1, most = std::numeric_limits<int>::max();
    const std::lock_guard lock(mutex);
    if (threads > known && known < most) {
        limitArenas();
        const int started = startableThreads(threads - 1);
        // Half of what there is room for: something is to be done there, too.
        if (started < threads - 1) most = std::max(1, started / 2);
        known = std::max(known, std::min(threads, most));
        if (known > 1) startThreads(known, run);
    }
    return std::min(threads, known);
}

}  // namespace core
