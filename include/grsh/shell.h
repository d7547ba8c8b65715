// The interpreter with every gr_* command, running a script or a prompt.
#pragma once

#include <tcl.h>

#include <string>
#include <vector>

namespace grsh {

class PipedScript;

// Writes to TCL_STDOUT or TCL_STDERR at once.
void print(int standardChannel, const std::string& text);

// Returns the exit code for it.
int sayInterrupted();

class Shell {
public:
    // program: its name as it was called.
    explicit Shell(const std::string& program);
    ~Shell();
    Shell(const Shell&) = delete;
    Shell& operator=(const Shell&) = delete;

    // Of scripts, UTF-8 if not set; false where Tcl has none of that name.
    bool setEncoding(const std::string& name);
    // Whether Tcl's stack trace follows the message of an error that nothing caught.
    void showTrace(bool shows) { showsTrace = shows; }

    // Each returns the process's exit code. Scripts see argv0 as their name and words as their further arguments.
    int runScript(const std::string& script, const std::vector<std::string>& words);
    int runStandardInput(const std::string& argv0, const std::vector<std::string>& words);
    int runPrompt(const std::string& argv0);

private:
    int evaluate(PipedScript& script, const std::string& text);
    // The exit code after an evaluation that ended with a code of Tcl's.
    int finish(int code);
    int fail();

    Tcl_Interp* interp;
    std::string encoding = "utf-8";
    bool showsTrace = false;
};

}  // namespace grsh
