// A flag that turns true when the time is over.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace render {

class Alarm {
public:
    // seconds: from now on; 0: never. The flag follows `stop`, too, soon.
    Alarm(double seconds, const std::atomic<bool>& stop) : stop_(stop) {
        if (seconds > 0)
            thread_ = std::jthread([this, end = Clock::now() + std::chrono::duration<double>(seconds)](
                                       const std::stop_token& done) { watch(end, done); });
    }

    const std::atomic<bool>& flag() const { return thread_.joinable() ? flag_ : stop_; }

private:
    using Clock = std::chrono::steady_clock;
    using Time = std::chrono::time_point<Clock, std::chrono::duration<double>>;

    void watch(Time end, const std::stop_token& done) {
        constexpr std::chrono::duration<double> glance(0.02);  // how often it looks at stop
        std::unique_lock lock(mutex_);
        while (!done.stop_requested() && !stop_ && Clock::now() < end) {
            const Time next = std::min<Time>(end, Clock::now() + glance);
            changed_.wait_until(lock, done, std::chrono::time_point_cast<Clock::duration>(next), [] { return false; });
        }
        flag_ = true;
    }

    const std::atomic<bool>& stop_;
    std::atomic<bool> flag_ = false;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::jthread thread_;
};

}  // namespace render
