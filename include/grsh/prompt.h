// Reads commands from a terminal and evaluates each, until the input ends.
#pragma once

#include <tcl.h>

namespace grsh {

void runPrompt(Tcl_Interp* interp);

}  // namespace grsh
