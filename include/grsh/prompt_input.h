// The prompt's standard input: Ctrl-C also ends a command that waits there.
#pragma once

#include <tcl.h>

namespace grsh {

// Tcl goes on reading after a signal; from here on it does not on standard input.
void makeInterruptible(Tcl_Interp* interp);

}  // namespace grsh
