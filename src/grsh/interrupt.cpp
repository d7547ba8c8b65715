#include "grsh/interrupt.h"

#include <semaphore.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <optional>
#include <utility>

#include "image/temporary_file.h"

namespace grsh {
namespace {

// A terminal sends a key's signal to all of a group of processes, one of which may send it on: that is still the first.
constexpr long kSecondCounts = 100;  // milliseconds
constexpr std::chrono::milliseconds kGrace(300);

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGXCPU};

std::atomic<bool> isInterrupted = false;
std::atomic<bool> isActedUpon = false;
std::atomic<bool> isEnding = false;
std::atomic<long> firstAt = 0;
std::atomic<int> firstSignal = 0;
std::atomic<int> scopes = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<long>::is_always_lock_free);
sem_t wake;
std::optional<Ending> theEnding;  // another one than a signal has

long milliseconds() {
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1000L + now.tv_nsec / 1000000L;
}

// False where it has begun before.
bool beginEnd(long now) {
    if (isInterrupted.exchange(true)) return false;
    firstAt = now;
    isActedUpon = false;
    return true;
}

// Calls nothing that a signal handler may not call; Tcl_AsyncMark locks, so a thread of its own calls that.
void onInterrupt(int number) {
    const int savedErrno = errno;
    const long now = milliseconds();
    if (beginEnd(now)) {
        firstSignal = number;
    } else if (number != SIGXCPU && now - firstAt >= kSecondCounts) {
        // SIGXCPU comes again every second.
        image::removeTemporaryFiles();
        signal(number, SIG_DFL);
        raise(number);
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
    endAtOnce();
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
            if (runs == InterruptHandler::Runs::script || firstSignal != SIGINT) endScriptThatWaits();
            std::this_thread::sleep_for(kGrace / 30);
        } while (isInterrupted && !isEnding);
    }
}

}  // namespace

std::atomic<bool>& interrupted() {
    return isInterrupted;
}

bool endsThePrompt() {
    return isInterrupted && firstSignal != SIGINT;
}

Ending ending() {
    if (theEnding) return *theEnding;
    constexpr int bySignal = 128;
    return {"grsh: interrupted\n", bySignal + firstSignal};
}

void endWith(Ending ending) {
    if (isInterrupted) return;
    theEnding = std::move(ending);
    beginEnd(milliseconds());
    sem_post(&wake);
}

void endAtOnce() {
    const Ending now = ending();
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, now.message.data(), now.message.size());
    image::removeTemporaryFiles();
    _exit(now.code);
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
    // A signal is to come to the interpreter's thread, whose waiting for a key then ends.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    marker = std::thread(waitForInterrupts, mark, runs);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    for (const int number : kSignals) {
        struct sigaction action = {}, before = {};
        sigaction(number, nullptr, &before);
        if (before.sa_handler == SIG_IGN) continue;
        action.sa_handler = onInterrupt;
        sigaction(number, &action, nullptr);
    }
}

InterruptHandler::~InterruptHandler() {
    for (const int number : kSignals) {
        struct sigaction now = {};
        sigaction(number, nullptr, &now);
        if (now.sa_handler == onInterrupt) signal(number, SIG_DFL);
    }
    isEnding = true;
    sem_post(&wake);
    marker.join();
    sem_destroy(&wake);
    Tcl_AsyncDelete(mark);
}

}  // namespace grsh
