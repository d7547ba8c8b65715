// Tcl's stack trace of an error (errorInfo) taken apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grsh {

// A text that a command stood in, in Tcl's words: file "x.gr", procedure "f", class "::C" method "m", "foreach" body.
struct ErrorUnit {
    std::string name;
    int line = 0;  // the command's line in it, from 1
};

// One command of the trace.
struct ErrorLevel {
    std::string command;  // backslash-newlines joined, as in ScriptText
    bool cut = false;  // Tcl shows only the first 150 bytes of a long command
    // Innermost first. None for what Tcl says nothing of: an arm of "if", "[...]".
    std::vector<ErrorUnit> units;
};

// Innermost first. message is the error's own, which errorInfo usually begins with.
std::vector<ErrorLevel> errorLevels(std::string_view errorInfo, std::string_view message);

}  // namespace grsh
