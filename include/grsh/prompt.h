// Reads commands from a terminal and evaluates each, until the input ends.
#pragma once

#include <tcl.h>

namespace grsh {

int runPrompt(Tcl_Interp* interp);

}  // namespace grsh
