// Loops over threads.
#include "core/parallel.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace core {
namespace {

TEST(ParallelFor, CallsEveryTaskOnce) {
    for (const int threads : {1, 2, 7}) {
        for (const int count : {0, 1, 5, 1000}) {
            std::vector<int> calls(static_cast<std::size_t>(count));
            parallelFor(count, threads, [&](int i) { ++calls[static_cast<std::size_t>(i)]; });
            EXPECT_THAT(calls, testing::Each(1));
        }
    }
}

// As many threads as asked for, also on a machine with fewer cores: a task waits until it has company.
TEST(ParallelFor, UsesTheThreadsAskedFor) {
    using namespace std::chrono_literals;
    for (const int threads : {1, 2, 7}) {
        std::atomic<int> running = 0, most = 0;
        std::mutex mutex;
        std::set<std::thread::id> ids;
        const auto deadline = std::chrono::steady_clock::now() + 10s;
        parallelFor(200, threads, [&](int) {
            const int now = ++running;
            int seen = most;
            while (seen < now && !most.compare_exchange_weak(seen, now)) {
            }
            while (most < threads && std::chrono::steady_clock::now() < deadline) std::this_thread::sleep_for(1ms);
            {
                const std::lock_guard lock(mutex);
                ids.insert(std::this_thread::get_id());
            }
            --running;
        });
        EXPECT_EQ(most, threads);
        EXPECT_LE(ids.size(), static_cast<std::size_t>(threads));
    }
}

TEST(ThreadCount, IsWhatIsAskedForOrAllCores) {
    EXPECT_EQ(threadCount(1), 1);
    EXPECT_EQ(threadCount(100), 100);
    EXPECT_GE(threadCount(0), 1);
    EXPECT_LE(threadCount(0), static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace
}  // namespace core
