// For ThreadSanitizer: that a library's tasks begin after what stands before them and end before what stands behind.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace core {

// Distributions' TBB and Embree are not compiled for ThreadSanitizer, which therefore does not see how they hand work
// to other threads and wait for its end. This tells it what they promise, and nothing more: two tasks of one ForkJoin
// have no order between them. In other builds it is nothing.
class ForkJoin {
public:
    // Lives as long as one task runs, on whatever thread.
    class Task {
    public:
        explicit Task(const ForkJoin& order) : order_(order) { acquire(&order_.forked_); }
        ~Task() { release(&order_.joined_); }
        Task(const Task&) = delete;
        Task& operator=(const Task&) = delete;

    private:
        const ForkJoin& order_;
    };

    // Calls `tasks`, which has the library run tasks and returns, or throws, when all of them have ended.
    template<class Tasks>
    void run(Tasks&& tasks) const {
        release(&forked_);
        const Join join{*this};
        tasks();
    }

private:
    struct Join {
        const ForkJoin& order;
        ~Join() { acquire(&order.joined_); }
    };

#ifdef __SANITIZE_THREAD__
    static void release(const char* place) {
        __tsan_release(const_cast<char*>(place));
    }
    static void acquire(const char* place) {
        __tsan_acquire(const_cast<char*>(place));
    }
#else
    static void release(const char*) {}
    static void acquire(const char*) {}
#endif

    char forked_ = 0, joined_ = 0;
};

}  // namespace core
