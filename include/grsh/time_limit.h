// A time after which the process ends, whatever it does.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace grsh {

// When the seconds are over while it lives, what goes on is ended as by a Ctrl-C, so that nothing temporary is left
// behind, and where that takes long the process ends at once: with a message, and exit code 1. There must be an
// InterruptHandler.
class TimeLimit {
public:
    explicit TimeLimit(std::optional<double> seconds);
    ~TimeLimit();
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;

private:
    void wait(double seconds);

    std::mutex mutex_;
    std::condition_variable over_;
    bool isOver_ = false;
    std::thread thread_;
};

}  // namespace grsh
