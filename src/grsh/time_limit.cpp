#include "grsh/time_limit.h"

#include <signal.h>

#include <chrono>

#include "core/option.h"
#include "grsh/interrupt.h"

namespace grsh {
namespace {

constexpr std::chrono::milliseconds kGrace(1500);

}  // namespace

TimeLimit::TimeLimit(std::optional<double> seconds) {
    if (!seconds) return;
    // Signals are for the interpreter's thread.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    thread_ = std::thread(&TimeLimit::wait, this, *seconds);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

TimeLimit::~TimeLimit() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        isOver_ = true;
    }
    over_.notify_all();
    thread_.join();
}

void TimeLimit::wait(double seconds) {
    std::unique_lock lock(mutex_);
    if (over_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return isOver_; })) return;
    endWith({"grsh: time limit of " + core::numberText(seconds) + " s reached\n", 1});
    if (over_.wait_for(lock, kGrace, [&] { return isOver_; })) return;
    endAtOnce();
}

}  // namespace grsh
