// The interpreter that a script runs in with --safe.
#pragma once

#include <tcl.h>

namespace grsh {

// A child of the interpreter, with Tcl's commands but those that reach files, programs, the net or other interpreters.
// registerCommands then adds ours, among them what takes the place of some of these; see safe_commands.cpp.
Tcl_Interp* makeSafeInterp(Tcl_Interp* parent);

}  // namespace grsh
