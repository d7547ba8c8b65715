// Ctrl-C. The signal only marks; the interpreter's own thread acts on the mark between two commands.
#pragma once

#include <tcl.h>

#include <atomic>
#include <string>
#include <thread>

namespace grsh {

// True from a Ctrl-C until the shell clears it before the next evaluation: the renderer's stop flag.
std::atomic<bool>& interrupted();

// What a script that was interrupted prints, and its exit code.
struct Ending {
    std::string message;
    int code;
};
const Ending& ending();

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

// While it lives, Ctrl-C ends the interpreter's evaluation with the error "interrupted", which nothing catches. Where
// that has had no effect for a second, a second Ctrl-C ends the process.
class InterruptHandler {
public:
    // A script is over at its first Ctrl-C, so a command that waits for something and holds no InterruptScope is given
    // 300 ms, then the process exits 130. A prompt goes on.
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
