// A line of a script, and how it is shown.
#pragma once

#include <tcl.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "grsh/tcl_value.h"

namespace grsh {

struct Place {
    std::string path;  // normalized
    int line = 0;
};

struct MainScript {
    std::string typed;
    std::string path;  // normalized
};

const MainScript* mainScript(Tcl_Interp* interp);

std::string normalized(const std::string& path);

// A line of Tcl's own library tells the writer of a script nothing.
bool isLibrary(Tcl_Interp* interp, const std::string& path);

// file:line, the main script as it was typed, others from the current directory where they are below it.
std::string shown(Tcl_Interp* interp, const Place& place);

// A file that is named in a script: from the folder of the file that holds the command; at the prompt, from the current
// folder. An absolute name stays. What it returns is as the system has it, not as Tcl does.
std::string besideScript(Tcl_Interp* interp, std::string_view file);

// The words' result as one command, or null where that is an error.
Value ask(Tcl_Interp* interp, std::initializer_list<std::string_view> words);

// The interpreter's result and error, kept from what is asked meanwhile.
class KeptState {
public:
    explicit KeptState(Tcl_Interp* interp)
        : interp(interp), line(Tcl_GetErrorLine(interp)), state(Tcl_SaveInterpState(interp, TCL_OK)) {}
    ~KeptState() {
        Tcl_RestoreInterpState(interp, state);
        Tcl_SetErrorLine(interp, line);
    }
    KeptState(const KeptState&) = delete;
    KeptState& operator=(const KeptState&) = delete;

private:
    Tcl_Interp* interp;
    int line;
    Tcl_InterpState state;
};

}  // namespace grsh
