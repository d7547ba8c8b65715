// Ctrl-C, and the signals that ask a process to end: SIGTERM, SIGHUP, SIGXCPU. The signal only marks; the interpreter's
// own thread acts on the mark between two commands.
#pragma once

#include <tcl.h>

#include <atomic>
#include <string>
#include <thread>

namespace grsh {

// True from a signal until the shell clears it before the next evaluation: the renderer's stop flag.
std::atomic<bool>& interrupted();
// A prompt goes on after a Ctrl-C, and ends after anything else.
bool endsThePrompt();

// What is printed where a signal has ended a script or a prompt, and the exit code: 128 + the signal, as shells have
// it.
struct Ending {
    std::string message;
    int code;
};
Ending ending();

// Interrupts as the first Ctrl-C does, from any thread, with another ending; only once.
void endWith(Ending ending);
// Ends the process now, with the ending's message and code.
[[noreturn]] void endAtOnce();

// Held by a command while it works long and polls interrupted(): it gives up what it has begun, tidies and returns an
// error, and no "catch" round it goes on.
class InterruptScope {
public:
    explicit InterruptScope(Tcl_Interp* interp);
    ~InterruptScope();
    InterruptScope(const InterruptScope&) = delete;
    InterruptScope& operator=(const InterruptScope&) = delete;

private:
    Tcl_Interp* interp;
};

// While it lives, these signals end the interpreter's evaluation with the error "interrupted", which nothing catches. A
// second one ends the process at once. What the process that started this one had ignored stays ignored.
class InterruptHandler {
public:
    // A script is over at its first signal, so a command that waits for something and holds no InterruptScope is given
    // 300 ms, then the process exits. A prompt goes on after a Ctrl-C.
    enum class Runs { script, prompt };

    InterruptHandler(Tcl_Interp* interp, Runs runs);
    ~InterruptHandler();
    InterruptHandler(const InterruptHandler&) = delete;
    InterruptHandler& operator=(const InterruptHandler&) = delete;

private:
    Tcl_AsyncHandler mark;
    std::thread marker;
};

}  // namespace grsh
