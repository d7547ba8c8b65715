// What is said where a script nests too deeply.
#pragma once

namespace grsh {

// From now on the process ends with a message and exit code 1, no crash, where its stack is at its end.
void guardStack();

}  // namespace grsh
