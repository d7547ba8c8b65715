// What follows a script that went well: windows stay open.
#pragma once

#include <tcl.h>

namespace grsh {

// Runs the loop that a library has set by Tcl_SetMainLoop, as Tk does, and then the command "exit", as tclsh does.
// Returns where no library was loaded that could have set one.
void runMainLoop(Tcl_Interp* interp);

}  // namespace grsh
