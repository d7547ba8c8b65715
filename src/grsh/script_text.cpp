#include "grsh/script_text.h"

#include <algorithm>

#include "grsh/error_info.h"
#include "grsh/piped_script.h"
#include "grsh/script_input.h"

namespace grsh {
namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

bool startsCommand(const std::string& text, std::size_t at) {
    while (at > 0 && isBlank(text[at - 1])) --at;
    return at == 0 || std::string_view("\n;[{\"").find(text[at - 1]) != std::string_view::npos;
}

bool endsCommand(const std::string& text, std::size_t at) {
    while (at < text.size() && isBlank(text[at])) ++at;
    return at == text.size() || std::string_view("\n;]}\"").find(text[at]) != std::string_view::npos;
}

// Where the level's command begins in [begin, end), or npos.
std::size_t findCommand(const std::string& text, std::size_t begin, std::size_t end, const ErrorLevel& level) {
    if (level.command.empty()) return std::string::npos;
    for (std::size_t at = text.find(level.command, begin); at < end; at = text.find(level.command, at + 1)) {
        const bool whole = level.cut || endsCommand(text, at + level.command.size());
        if (whole && startsCommand(text, at)) return at;
    }
    return std::string::npos;
}

// Whether a word opens line - 1 lines above: only then can the command be on that line of the word.
bool isOnLineOfWord(const CommandSpan& enclosing, std::size_t at, int line) {
    const std::string& text = enclosing.script->text;
    for (int above = line - 1; at > enclosing.begin; --at) {
        const char before = text[at - 1];
        if (before == '\n' && above-- == 0) return false;
        if (above == 0 && (before == '{' || before == '"' || before == '[')) return true;
    }
    return false;
}

}  // namespace

std::size_t ScriptText::startOf(int line) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(lines, line) - lines.begin());
}

int CommandSpan::line() const {
    return begin < script->lines.size() ? script->lines[begin] : 1;
}

ScriptText joinLines(std::string_view raw) {
    ScriptText script;
    script.text.reserve(raw.size());
    script.lines.reserve(raw.size());
    int line = 1;
    const auto put = [&](char c) {
        script.text += c;
        script.lines.push_back(line);
        if (c == '\n') ++line;
    };
    for (std::size_t i = 0; i < raw.size(); ++i) {
        const bool escapes = raw[i] == '\\' && i + 1 < raw.size();
        if (escapes && raw[i + 1] == '\n') {
            put(' ');
            ++line;
            ++i;
            while (i + 1 < raw.size() && isBlank(raw[i + 1])) ++i;
        } else {
            put(raw[i]);
            if (escapes) put(raw[++i]);
        }
    }
    return script;
}

std::optional<ScriptText> readScript(const std::string& path) {
    if (const auto piped = pipedText(path)) return joinLines(*piped);
    // A pipe that was read is empty, or waits for ever.
    if (!isRegularFile(path)) return std::nullopt;
    const Tcl_Channel channel = Tcl_OpenFileChannel(nullptr, path.c_str(), "r", 0);
    if (!channel) return std::nullopt;
    Tcl_SetChannelOption(nullptr, channel, "-eofchar", "\032");
    Tcl_Obj* text = Tcl_NewObj();
    Tcl_IncrRefCount(text);
    const bool isRead = Tcl_ReadChars(channel, text, -1, 0) >= 0;
    Tcl_Close(nullptr, channel);
    int length = 0;
    const char* bytes = Tcl_GetStringFromObj(text, &length);
    std::optional<ScriptText> script;
    if (isRead) script = joinLines({bytes, static_cast<std::size_t>(length)});
    Tcl_DecrRefCount(text);
    return script;
}

CommandSpan commandAt(const ScriptText& script, std::size_t begin) {
    const int length = static_cast<int>(script.text.size() - begin);
    // First as a command on its own lines, then as one in brackets.
    for (const int inBrackets : {0, 1}) {
        Tcl_Parse parse;
        if (Tcl_ParseCommand(nullptr, script.text.data() + begin, length, inBrackets, &parse) != TCL_OK) continue;
        const auto size = static_cast<std::size_t>(parse.commandStart - parse.string + parse.commandSize);
        Tcl_FreeParse(&parse);
        return {&script, begin, begin + size};
    }
    return {&script, begin, script.text.size()};
}

std::optional<CommandSpan> commandOnLine(const ScriptText& script, std::size_t begin, int line,
                                         const ErrorLevel& level) {
    for (int above = line - 1; above > 0; --above) {
        const std::size_t newline = script.text.find('\n', begin);
        if (newline == std::string::npos) return std::nullopt;
        begin = newline + 1;
    }
    const std::size_t end = std::min(script.text.find('\n', begin), script.text.size());
    const std::size_t at = findCommand(script.text, begin, end, level);
    if (at == std::string::npos) return std::nullopt;
    return commandAt(script, at);
}

std::optional<CommandSpan> commandWithin(const CommandSpan& enclosing, int line, const ErrorLevel& level) {
    const std::string& text = enclosing.script->text;
    std::size_t at = findCommand(text, enclosing.begin + 1, enclosing.end, level);
    while (at != std::string::npos && line > 0 && !isOnLineOfWord(enclosing, at, line))
        at = findCommand(text, at + 1, enclosing.end, level);
    if (at == std::string::npos) return std::nullopt;
    return commandAt(*enclosing.script, at);
}

}  // namespace grsh
