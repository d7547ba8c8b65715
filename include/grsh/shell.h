// The interpreter with every gr_* command, running a script or a prompt.
#pragma once

#include <tcl.h>

#include <string>
#include <vector>

namespace grsh {

// Writes to TCL_STDOUT or TCL_STDERR at once.
void print(int standardChannel, const std::string& text);

class Shell {
public:
    // program: its name as it was called.
    explicit Shell(const std::string& program);
    ~Shell();
    Shell(const Shell&) = delete;
    Shell& operator=(const Shell&) = delete;

    // Each returns the process's exit code. Scripts see argv0 as their name and words as their further arguments.
    int runScript(const std::string& script, const std::vector<std::string>& words);
    int runStandardInput(const std::string& argv0, const std::vector<std::string>& words);
    int runPrompt(const std::string& argv0);

private:
    int runFile(const std::string& typed, const std::string& path);

    Tcl_Interp* interp;
};

}  // namespace grsh
