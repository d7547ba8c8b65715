// Reads scripts that are no files: pipes and standard input.
#pragma once

#include <string>

#include "grsh/command_text.h"

namespace grsh {

// 0, or why the file cannot be read. It is not opened: a pipe can be read only once.
int readError(const std::string& path);

bool isRegularFile(const std::string& path);

// All of a file as Tcl has it; false where it cannot be read, errno telling why. path is as Tcl has it, too.
bool readAll(const std::string& path, const std::string& encoding, std::string& text);

// Adds the next line of standard input; false at the end.
bool readLine(CommandText& command);

}  // namespace grsh
