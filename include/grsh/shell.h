// The interpreter with every gr_* command, running a script or a prompt.
#pragma once

#include <tcl.h>

#include <memory>
#include <string>
#include <vector>

#include "grsh/command_line.h"
#include "grsh/file_access.h"
#include "grsh/overrides.h"
#include "grsh/unread_words.h"

namespace grsh {

class PipedScript;

// Writes to TCL_STDOUT or TCL_STDERR at once.
void print(int standardChannel, const std::string& text);

// Returns the exit code for it.
int sayInterrupted();

class Shell {
public:
    // program: its name as it was called. Throws core::Error, e.g. for a folder that the line names and is not there.
    Shell(const std::string& program, const CommandLine& line);
    ~Shell();
    Shell(const Shell&) = delete;
    Shell& operator=(const Shell&) = delete;

    // Runs what the line says and returns the process's exit code.
    int run();

private:
    // Scripts see argv0 as their name and words as their further arguments.
    int runScript(const std::string& script, const std::vector<std::string>& words);
    int runText(const std::string& text, const std::vector<std::string>& words);
    int runStandardInput(const std::string& argv0, const std::vector<std::string>& words);
    int runPrompt(const std::string& argv0);
    int evaluate(PipedScript& script, const std::string& text);
    // The exit code after an evaluation that ended with a code of Tcl's.
    int finish(int code, UnreadWords& unread);
    int fail();

    std::string program;
    CommandLine line;
    FileAccess files;
    Overrides overrides;
    Tcl_Interp* parent;  // what all interpreters belong to
    Tcl_Interp* interp;  // what scripts run in: the parent, or with --safe its child
};

}  // namespace grsh
