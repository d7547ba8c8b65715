#include "grsh/stack_guard.h"

#include "grsh/last_resort.h"

#include <pthread.h>
#include <signal.h>

#include <cstddef>
#include <cstdint>

namespace grsh {
namespace {

constexpr std::size_t kBelowStack = 1 << 20;  // what lies below a stack that is at its end
std::uintptr_t stackBegin = 0, stackEnd = 0;
alignas(16) char signalStack[1 << 16];

// Any other crash stays one.
void onFault(int number, siginfo_t* info, void*) {
    const auto at = reinterpret_cast<std::uintptr_t>(info->si_addr);
    if (at + kBelowStack >= stackBegin && at < stackEnd) giveUp("the script nests too deeply");
    signal(number, SIG_DFL);
    raise(number);
}

}  // namespace

void guardStack() {
    pthread_attr_t attributes;
    if (pthread_getattr_np(pthread_self(), &attributes) != 0) return;
    void* begin = nullptr;
    std::size_t size = 0;
    pthread_attr_getstack(&attributes, &begin, &size);
    pthread_attr_destroy(&attributes);
    stackBegin = reinterpret_cast<std::uintptr_t>(begin);
    stackEnd = stackBegin + size;
    stack_t own = {};
    own.ss_sp = signalStack;
    own.ss_size = sizeof signalStack;
    sigaltstack(&own, nullptr);
    struct sigaction action = {};
    action.sa_sigaction = onFault;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigaction(SIGSEGV, &action, nullptr);
}

}  // namespace grsh
