#include "grsh/unread_words.h"

#include "grsh/command_line.h"
#include "grsh/option_words.h"
#include "grsh/overrides.h"
#include "grsh/shell.h"

#include <algorithm>
#include <array>

namespace grsh {
namespace {

constexpr std::array<const char*, 2> variables = {"argv", "argc"};
// A trace of C's is none that a script sees.
constexpr int traced = TCL_GLOBAL_ONLY | TCL_TRACE_READS | TCL_TRACE_UNSETS;

char* noteRead(ClientData isSettled, Tcl_Interp*, const char*, const char*, int) {
    *static_cast<bool*>(isSettled) = true;
    return nullptr;
}

void tellAtExit(ClientData words) {
    static_cast<UnreadWords*>(words)->tell();
}

// The option of --set that a word means, with its dashes or without; empty where it means none.
std::string optionMeant(const std::string& word, Spelling spelling) {
    const std::string name = word.substr(std::min(word.find_first_not_of('-'), word.size()));
    const auto names = Overrides::names();
    if (findOption(render::RenderSettings::options(), name) != nullptr || std::ranges::count(names, name) > 0)
        return name;
    return word.starts_with('-') && spelling == Spelling::near ? core::nearest(name, names) : "";
}

// What was meant by the words from `at` on, for a command line; nothing where that cannot be told. Goes on to the next.
std::string meant(const std::vector<std::string>& words, std::size_t& at) {
    const std::string& word = words[at];
    const std::size_t count = wordsOfOption(word);
    if (count == 0) return setMeant(words, at, Spelling::near);
    std::string text = word;
    ++at;
    for (std::size_t i = 1; i < count && at < words.size(); ++i) text += " " + inShell(words[at++]);
    return text;
}

std::string warningText(const std::string& script, const std::string& written, const std::vector<std::string>& words) {
    std::string given, line;
    for (const std::string& word : words) given += (given.empty() ? "" : " ") + word;
    for (std::size_t at = 0; at < words.size();)
        if (const std::string text = meant(words, at); !text.empty()) line += " " + text;
    const std::string how = line.empty() ? "; grsh --set option=value " + written + " sets an option of gr_render"
                                         : " (did you mean \"grsh" + line + " " + written + "\"?)";
    return script + ": warning: the script has not read the words behind its name, " + quoted(given) + how + "\n";
}

}  // namespace

std::string inShell(const std::string& word) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
    return text + "'";
}

std::string setMeant(const std::vector<std::string>& words, std::size_t& at, Spelling spelling) {
    const std::string& word = words[at++];
    const std::size_t equals = word.find('=');
    const std::string name = optionMeant(word.substr(0, equals), spelling);
    if (name.empty()) return "";
    if (equals != std::string::npos) return "--set " + inShell(name + word.substr(equals));
    return at == words.size() ? "" : "--set " + inShell(name + "=" + words[at++]);
}

UnreadWords::UnreadWords(Tcl_Interp* interp, const std::string& script, const std::string& written,
                         const std::vector<std::string>& words)
    : interp_(interp), isSettled_(words.empty()) {
    if (isSettled_) return;
    warning_ = warningText(script, written, words);
    for (const char* variable : variables) Tcl_TraceVar(interp, variable, traced, noteRead, &isSettled_);
    Tcl_CreateExitHandler(tellAtExit, this);
}

UnreadWords::~UnreadWords() {
    Tcl_DeleteExitHandler(tellAtExit, this);
    for (const char* variable : variables) Tcl_UntraceVar(interp_, variable, traced, noteRead, &isSettled_);
}

void UnreadWords::tell() {
    if (!isSettled_) print(TCL_STDERR, warning_);
    isSettled_ = true;
}

}  // namespace grsh
