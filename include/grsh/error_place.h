// Where in the scripts something happened, as "file:line" for a person to read.
#pragma once

#include <tcl.h>

#include <string>

namespace grsh {

// The script named on the command line, shown as it was typed; path is what Tcl reads it from.
void setMainScript(Tcl_Interp* interp, const std::string& typed, const std::string& path);

// The command being evaluated now: the innermost that stands in a file, else "" (at the prompt).
std::string place(Tcl_Interp* interp);

// The command whose error ended the last evaluation: the innermost that stands in a file, else "". It is found from
// Tcl's stack trace and the scripts' text after the fact, so a script that catches its errors pays nothing for it.
std::string errorPlace(Tcl_Interp* interp);

}  // namespace grsh
