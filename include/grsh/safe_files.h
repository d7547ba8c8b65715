// Tcl's own use of files in safe mode: "source", "file exists", its library.
#pragma once

#include <tcl.h>

#include "grsh/file_access.h"

namespace grsh {

// From now on every file that Tcl opens, in any interpreter, is one that files may open, and none is opened for
// writing. For the rest of the process.
void confineTcl(FileAccess& files, Tcl_Interp* interp);

}  // namespace grsh
