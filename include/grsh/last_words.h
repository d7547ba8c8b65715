// What is said where Tcl can only give up.
#pragma once

namespace grsh {

// From now on the process ends with a message and exit code 1, no crash, where Tcl gets no memory, and where a script
// nests so deeply that the stack is at its end.
void prepareLastWords();

}  // namespace grsh
