// A script's text and the commands in it.
#pragma once

#include <tcl.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grsh {

// Text with every backslash-newline joined to one blank, as Tcl joins it inside braces before it counts an error's
// lines; lines holds each character's line in the file.
struct ScriptText {
    std::string text;
    std::vector<int> lines;

    std::size_t startOf(int line) const;
};

// A command's extent in a script's text.
struct CommandSpan {
    const ScriptText* script = nullptr;
    std::size_t begin = 0;
    std::size_t end = 0;

    int line() const;
};

struct ErrorLevel;

ScriptText joinLines(std::string_view raw);
std::optional<ScriptText> readScript(const std::string& path);

// The command that begins at an offset.
CommandSpan commandAt(const ScriptText& script, std::size_t begin);

// The level's command on a line, from 1, of the text that begins at an offset; nothing where it is not there.
std::optional<CommandSpan> commandOnLine(const ScriptText& script, std::size_t begin, int line,
                                         const ErrorLevel& level);

// The level's command within an enclosing one, on a line of one of its words, from 1; 0: on any line.
std::optional<CommandSpan> commandWithin(const CommandSpan& enclosing, int line, const ErrorLevel& level);

}  // namespace grsh
