// What is done where there is no memory left, or nothing else can be done: a message and exit code 1, never a signal.
#pragma once

namespace grsh {

// From here on Tcl's panics and exceptions that nothing catches end the process with a message.
void installLastResort();

// Ends the process at once with "grsh: ", the message, and exit code 1. It allocates nothing, and a signal handler may
// call it.
[[noreturn]] void giveUp(const char* message);

// Memory kept for telling that there is no more. A command releases it where it fails for want of memory, and takes it
// again when the next one begins.
void takeReserve() noexcept;
void releaseReserve() noexcept;

}  // namespace grsh
