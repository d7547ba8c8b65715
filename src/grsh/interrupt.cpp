#include "grsh/interrupt.h"

#include <semaphore.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>

namespace grsh {
namespace {

constexpr long kSecondCounts = 1000;  // milliseconds after the first Ctrl-C
constexpr std::chrono::milliseconds kGrace(300);

std::atomic<bool> isInterrupted = false;
std::atomic<bool> isActedUpon = false;
std::atomic<bool> isEnding = false;
std::atomic<long> firstAt = 0;
std::atomic<int> scopes = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<long>::is_always_lock_free);
sem_t wake;

long milliseconds() {
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1000L + now.tv_nsec / 1000000L;
}

// Calls nothing that a signal handler may not call; Tcl_AsyncMark locks, so a thread of its own calls that.
void onInterrupt(int) {
    const int savedErrno = errno;
    const long now = milliseconds();
    if (!isInterrupted.exchange(true)) {
        firstAt = now;
        isActedUpon = false;
    } else if (now - firstAt >= kSecondCounts) {
        signal(SIGINT, SIG_DFL);
        raise(SIGINT);
    }
    sem_post(&wake);
    errno = savedErrno;
}

void endEvaluation(Tcl_Interp* interp) {
    isActedUpon = true;
    // Tcl_CancelEval releases the message.
    Tcl_CancelEval(interp, Tcl_NewStringObj("interrupted", -1), nullptr, TCL_CANCEL_UNWIND);
}

// The mark may be older than the evaluation it comes to: then the shell has cleared the flag.
int onMark(ClientData interp, Tcl_Interp*, int code) {
    if (isInterrupted) endEvaluation(static_cast<Tcl_Interp*>(interp));
    return code;
}

// Tcl reads on after a signal, and "after" and "exec" sleep on.
void endScriptThatWaits() {
    using Clock = std::chrono::steady_clock;
    auto until = Clock::now() + kGrace;
    while (Clock::now() < until) {
        std::this_thread::sleep_for(kGrace / 30);
        if (isActedUpon || isEnding) return;
        if (scopes > 0) until = Clock::now() + kGrace;
    }
    constexpr char kMessage[] = "grsh: interrupted\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMessage, sizeof kMessage - 1);
    _exit(130);
}

void waitForInterrupts(Tcl_AsyncHandler mark, InterruptHandler::Runs runs) {
    while (true) {
        while (sem_wait(&wake) != 0 && errno == EINTR) {
        }
        if (isEnding) return;
        // Again and again until all evaluation has ended: what ends in a trace goes on behind it.
        do {
            isActedUpon = false;
            Tcl_AsyncMark(mark);
            if (runs == InterruptHandler::Runs::script) endScriptThatWaits();
            std::this_thread::sleep_for(kGrace / 30);
        } while (isInterrupted && !isEnding);
    }
}

}  // namespace

std::atomic<bool>& interrupted() {
    return isInterrupted;
}

InterruptScope::InterruptScope(Tcl_Interp* interp) : interp(interp) {
    ++scopes;
}

InterruptScope::~InterruptScope() {
    if (isInterrupted) {
        endEvaluation(interp);
        // At once: a trace that runs next would take the end for its own, and Tcl forget it behind that.
        Tcl_AsyncInvoke(interp, TCL_OK);
    }
    --scopes;
}

InterruptHandler::InterruptHandler(Tcl_Interp* interp, Runs runs) : mark(Tcl_AsyncCreate(onMark, interp)) {
    isEnding = false;
    sem_init(&wake, 0, 0);
    // The signal is to come to the interpreter's thread, whose waiting for a key then ends.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    marker = std::thread(waitForInterrupts, mark, runs);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    struct sigaction action = {};
    action.sa_handler = onInterrupt;
    sigaction(SIGINT, &action, nullptr);
}

InterruptHandler::~InterruptHandler() {
    signal(SIGINT, SIG_DFL);
    isEnding = true;
    sem_post(&wake);
    marker.join();
    sem_destroy(&wake);
    Tcl_AsyncDelete(mark);
}

}  // namespace grsh
